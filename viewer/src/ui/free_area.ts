// SPDX-License-Identifier: Apache-2.0
// What controls and legends leave free of the view.

/** In CSS pixels of the view. */
export interface FreeArea {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** The largest upright rectangle of a view that overlaps none of the boxes in it. */
export function largest_free(width: number, height: number, boxes: FreeArea[]): FreeArea {
  const lefts = [0, ...boxes.map(({ right }) => right)];
  const rights = [width, ...boxes.map(({ left }) => left)];
  const tops = [0, ...boxes.map(({ bottom }) => bottom)];
  const bottoms = [height, ...boxes.map(({ top }) => top)];
  let best = { left: 0, right: width, top: 0, bottom: height };
  let most = 0;
  for (const left of lefts) for (const right of rights) for (const top of tops) for (const bottom of bottoms) {
    if (left < 0 || top < 0 || right > width || bottom > height || right <= left || bottom <= top) continue;
    const area = (right - left) * (bottom - top);
    if (area <= most || boxes.some((box) => box.left < right && box.right > left && box.top < bottom && box.bottom > top)) continue;
    [best, most] = [{ left, right, top, bottom }, area];
  }
  return best;
}

// Between the part and what is beside it.
const kMargin = 8;

/** What is free of a view, beside parts of the page that lie over it. It depends on what is there now alone, so that links restore views. */
export function free_area(stage: HTMLElement, over: HTMLElement[]): FreeArea {
  const view = stage.getBoundingClientRect();
  const boxes = over.filter((part) => part.checkVisibility()).map((part) => part.getBoundingClientRect()).filter(({ width }) => width > 0)
    .map(({ left, right, top, bottom }) => ({ left: left - view.left - kMargin, right: right - view.left + kMargin, top: top - view.top - kMargin, bottom: bottom - view.top + kMargin }));
  return largest_free(view.width, view.height, boxes);
}
