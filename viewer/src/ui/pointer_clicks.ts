// SPDX-License-Identifier: Apache-2.0
// Clicks and taps on the canvas, told from drags that turn the part.

// A finger rests less exactly than a mouse.
const kSlack = { mouse: 4, touch: 10, pen: 6 };

export class PointerClicks {
  constructor(canvas: HTMLCanvasElement, click: (x: number, y: number) => void, double_click: (x: number, y: number) => void) {
    let start: { x: number; y: number; id: number } | null = null;
    let pointers = 0;
    const place = (event: MouseEvent): [number, number] => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    canvas.addEventListener("pointerdown", (event) => {
      ++pointers;
      start = pointers === 1 && event.button === 0 ? { x: event.clientX, y: event.clientY, id: event.pointerId } : null;
    });
    const ended = (event: PointerEvent): void => {
      pointers = Math.max(0, pointers - 1);
      if (event.type === "pointerup" && start?.id === event.pointerId) {
        const slack = kSlack[event.pointerType as keyof typeof kSlack] ?? 4;
        if (Math.hypot(event.clientX - start.x, event.clientY - start.y) <= slack) click(...place(event));
      }
      start = null;
    };
    canvas.addEventListener("pointerup", ended);
    canvas.addEventListener("pointercancel", ended);
    canvas.addEventListener("dblclick", (event) => double_click(...place(event)));
  }
}
