// SPDX-License-Identifier: Apache-2.0
// Making elements, and numbers as people read them: a dash for those that the report has null for, since they are not finite.

type Child = Node | string | null | undefined | false;
type Attributes = Record<string, string | number | boolean | undefined | ((event: Event) => void)>;

function fill<T extends Element>(node: T, attributes: Attributes, children: Child[]): T {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    if (typeof value === "function") node.addEventListener(name, value);
    else node.setAttribute(name, value === true ? "" : String(value));
  }
  for (const child of children) if (child) node.append(child);
  return node;
}

/** An element; attributes that are functions listen to the event of that name. */
export function element<K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Attributes = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  return fill(document.createElement(tag), attributes, children);
}

export function drawing<K extends keyof SVGElementTagNameMap>(tag: K, attributes: Attributes = {}, ...children: Child[]): SVGElementTagNameMap[K] {
  return fill(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, children);
}

export const by_id = (id: string): HTMLElement => document.getElementById(id)!;

/** 30,093 */
export const counted = (value: number): string => Math.round(value).toLocaleString("en-US");

/** Coordinates below this share of the largest are rounding. */
const kRounding = 1e-5;

/** Coordinates of a place; what is rounding beside the largest is 0. */
export function coordinates(place: readonly number[], digits = 4): string {
  const largest = Math.max(...place.map(Math.abs));
  return place.map((value) => measured(Math.abs(value) < kRounding * largest ? 0 : value, digits)).join(", ");
}

/** Three significant digits, with powers of ten for what is very large or small. */
export function measured(value: number, digits = 3): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-3) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    return `${mantissa}·10${superscript(Number(exponent))}`.replace("-", "−");
  }
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return value.toLocaleString("en-US", { maximumFractionDigits: decimals }).replace("-", "−");
}

export const superscript = (value: number): string =>
  String(value).replace(/[-0-9]/g, (digit) => (digit === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(digit)]));

export const degrees = (value: number): string => (Number.isFinite(value) ? `${value.toFixed(value < 10 ? 2 : 1)}°` : "–");

export function duration(seconds: number): string {
  if (!Number.isFinite(seconds)) return "–";
  const milliseconds = Math.max(1, Math.round(seconds * 1000));
  if (milliseconds < 1000) return `${milliseconds} ms`;
  if (seconds < 100) return `${measured(seconds)} s`;
  const rounded = Math.round(seconds);
  return `${Math.floor(rounded / 60)} min ${rounded % 60} s`;
}

export function memory(bytes: number): string {
  const megabytes = Math.round(bytes / 1e6);
  return megabytes >= 1000 ? `${(bytes / 1e9).toFixed(1)} GB` : `${megabytes} MB`;
}

export const plural = (count: number, one: string, many = `${one}s`): string => `${counted(count)} ${count === 1 ? one : many}`;

/** 1 cell, 2.75 cells */
export const amount = (value: number, one: string, digits = 3): string => `${measured(value, digits)} ${measured(value, digits) === "1" ? one : `${one}s`}`;
