// SPDX-License-Identifier: Apache-2.0
// A picture of the view as a PNG file, with the legend drawn into it where it stands on the page.

import type { Stage } from "../view/stage.ts";
import { by_id, element } from "./dom.ts";

// Pixels of the picture for each of the page: enough for print.
const kScale = 2;

/** The picture as a canvas. */
export async function picture_of(stage: Stage): Promise<HTMLCanvasElement> {
  const picture = element("canvas", {});
  const context = picture.getContext("2d")!;
  stage.at_scale(kScale, (drawn) => {
    [picture.width, picture.height] = [drawn.width, drawn.height];
    context.drawImage(drawn, 0, 0);
  });
  const legend = by_id("legend");
  if (legend.checkVisibility() && by_id("legend-body").children.length > 0) {
    context.scale(kScale, kScale);
    const origin = stage.canvas.getBoundingClientRect();
    context.translate(-origin.left, -origin.top);
    await draw_legend(context, legend);
  }
  return picture;
}

export async function save_picture(stage: Stage): Promise<void> {
  const picture = await picture_of(stage);
  const blob = await new Promise<Blob | null>((resolve) => picture.toBlob(resolve, "image/png"));
  if (!blob) return;
  const link = element("a", { href: URL.createObjectURL(blob), download: `${document.title.split(" · ")[0].replace(/\.\w+$/, "")}.png` });
  link.click();
  // The browser may begin to read it only after this.
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Paints what legends are made of: a card, texts, swatches, ramps and small drawings. */
async function draw_legend(context: CanvasRenderingContext2D, legend: HTMLElement): Promise<void> {
  const card = legend.getBoundingClientRect();
  const style = getComputedStyle(legend);
  context.fillStyle = style.backgroundColor;
  context.strokeStyle = style.borderTopColor;
  context.beginPath();
  context.roundRect(card.left, card.top, card.width, card.height, 8);
  context.fill();
  context.stroke();
  for (const part of legend.querySelectorAll<HTMLElement | SVGElement>(".ramp, .swatch, svg")) {
    const box = part.getBoundingClientRect();
    if (!part.checkVisibility()) continue;
    if (part instanceof SVGElement) context.drawImage(await image_of(part), box.left, box.top, box.width, box.height);
    else {
      context.fillStyle = part.classList.contains("ramp") ? gradient_of(context, part, box) : getComputedStyle(part).backgroundColor;
      context.fillRect(box.left, box.top, box.width, box.height);
    }
  }
  const texts = document.createTreeWalker(legend, NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) draw_text(context, texts.currentNode as Text);
}

function draw_text(context: CanvasRenderingContext2D, text: Text): void {
  const parent = text.parentElement;
  if (!parent || !parent.checkVisibility() || text.data.trim() === "") return;
  const { color, fontFamily, fontSize, fontStyle, fontWeight } = getComputedStyle(parent);
  context.font = `${fontStyle} ${fontWeight} ${fontSize} ${fontFamily}`;
  context.fillStyle = color;
  context.textBaseline = "middle";
  const range = document.createRange();
  // Word by word, since a line may be broken anywhere between two.
  for (const { 0: word, index } of text.data.matchAll(/\S+/g)) {
    range.setStart(text, index);
    range.setEnd(text, index + word.length);
    const box = range.getBoundingClientRect();
    context.fillText(word, box.left, box.top + box.height / 2);
  }
}

function gradient_of(context: CanvasRenderingContext2D, ramp: HTMLElement, box: DOMRect): CanvasGradient {
  const colors = getComputedStyle(ramp).backgroundImage.match(/rgba?\([^)]*\)/g) ?? [];
  const gradient = context.createLinearGradient(box.left, 0, box.right, 0);
  colors.forEach((color, k) => gradient.addColorStop(k / Math.max(1, colors.length - 1), color));
  return gradient;
}

async function image_of(drawing: SVGElement): Promise<HTMLImageElement> {
  const copy = drawing.cloneNode(true) as SVGElement;
  const { width, height } = drawing.getBoundingClientRect();
  copy.setAttribute("width", String(width * kScale));
  copy.setAttribute("height", String(height * kScale));
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(new XMLSerializer().serializeToString(copy))}`;
  await image.decode();
  return image;
}
