// SPDX-License-Identifier: Apache-2.0
// What to do about a result, in options of `crossgrain hex`, as its terminal says.

const kOptions: Record<string, (number?: number) => string> = {
  take_larger_hexahedra: () => "raise --size, or lower --cells",
  use_hex_size: (size) => `try --size ${size}`,
  use_edge_length: (size) => `try --tet-size ${size}`,
  glue_solids: () => "glue them (--glue)",
};

/** The words of a remedy by its name; the given ones where no option is known. */
export const advice_on = (remedy: string | undefined, number: number | undefined, words: string | undefined): string => kOptions[remedy ?? ""]?.(number) ?? words ?? "";
