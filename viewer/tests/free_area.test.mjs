// SPDX-License-Identifier: Apache-2.0
// What controls and legends leave free of the view.

import assert from "node:assert/strict";
import { test } from "node:test";

import { largest_free } from "../src/ui/free_area.ts";

test("without anything over it all of the view is free", () => {
  assert.deepEqual(largest_free(800, 600, []), { left: 0, right: 800, top: 0, bottom: 600 });
});

test("a panel, a bar and a legend leave what lies between them", () => {
  const panel = { left: 0, right: 250, top: 0, bottom: 560 };
  const bar = { left: 400, right: 800, top: 0, bottom: 50 };
  const legend = { left: 300, right: 800, top: 480, bottom: 600 };
  assert.deepEqual(largest_free(800, 600, [panel, bar, legend]), { left: 250, right: 800, top: 50, bottom: 480 });
});

test("no rectangle beside the boxes is larger, for any boxes", () => {
  let seed = 7;
  const random = (most) => (seed = (seed * 48271) % 2147483647) % most;
  const overlaps = (a, b) => a.left < b.right && a.right > b.left && a.top < b.bottom && a.bottom > b.top;
  for (let trial = 0; trial < 40; ++trial) {
    const boxes = Array.from({ length: 3 }, () => {
      const [left, top] = [random(12), random(12)];
      return { left, right: left + 1 + random(6), top, bottom: top + 1 + random(6) };
    });
    const found = largest_free(14, 14, boxes);
    assert.ok(!boxes.some((box) => overlaps(found, box)));
    let most = 0;
    for (let left = 0; left < 14; ++left) for (let right = left + 1; right <= 14; ++right) for (let top = 0; top < 14; ++top) for (let bottom = top + 1; bottom <= 14; ++bottom) {
      const area = (right - left) * (bottom - top);
      if (area > most && !boxes.some((box) => overlaps({ left, right, top, bottom }, box))) most = area;
    }
    assert.equal((found.right - found.left) * (found.bottom - found.top), most);
  }
});
