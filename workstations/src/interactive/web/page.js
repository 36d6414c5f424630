// Shows the picture that a program sends, and tells the program what the operator does.
"use strict";

const canvas = document.getElementById("picture");
const state = document.getElementById("state");
const take = document.getElementById("take");
const context = canvas.getContext("2d");
const words = { waiting: "connecting", steering: "steering", watching: "watching", ended: "ended" };

// Names of keys in the order in which the program numbers them.
const keys = ["Enter", "Escape", "Backspace", "Delete", "Tab", "ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown",
  "Home", "End", "PageUp", "PageDown"];
const MOVED = 1, PRESSED = 2, RELEASED = 3, WHEEL = 4, KEY = 5, FUNCTION = 6, CHARACTER = 7;

const address = new URL("socket", location.href);
address.protocol = "ws:";
const socket = new WebSocket(address);
socket.binaryType = "arraybuffer";

function show(now) {
  if (state.dataset.state === "ended") return;
  state.dataset.state = canvas.dataset.state = now;
  state.textContent = words[now];
  take.hidden = now !== "watching";
}

// Pieces of pictures are decoded at different speeds, and shall appear in the order in which they came.
let last = Promise.resolve();

socket.onmessage = ({ data }) => {
  const view = new DataView(data);
  switch (view.getUint8(0)) {
    case 0:
      canvas.width = view.getUint32(1, true);
      canvas.height = view.getUint32(5, true);
      const title = new TextDecoder().decode(new Uint8Array(data, 9));
      if (title) {
        document.getElementById("title").textContent = title;
        document.title = title + " - GKS";
      }
      break;
    case 1: {
      const x = view.getUint32(1, true), y = view.getUint32(5, true);
      const bitmap = createImageBitmap(new Blob([new Uint8Array(data, 9)], { type: "image/png" }));
      last = last.then(() => bitmap).then((part) => {
        context.drawImage(part, x, y);
        part.close();
        canvas.dataset.painted = Number(canvas.dataset.painted || 0) + 1;
      });
      break;
    }
    case 2:
      show(view.getUint8(1) ? "steering" : "watching");
      if (pointer) point(MOVED, pointer, 0);
      canvas.focus();
      break;
    case 3:
      show("ended");
      break;
  }
};
socket.onclose = () => show("ended");

function send(tag, number, x, y) {
  if (state.dataset.state !== "steering" || socket.readyState !== WebSocket.OPEN) return;
  const view = new DataView(new ArrayBuffer(18));
  view.setUint8(0, tag);
  view.setUint8(1, number);
  view.setFloat64(2, x, true);
  view.setFloat64(10, y, true);
  socket.send(view.buffer);
}

// Where the pointer was last, on the page. It may rest on the picture before this page steers.
let pointer = null;

function point(tag, event, number) {
  pointer = { clientX: event.clientX, clientY: event.clientY };
  const box = canvas.getBoundingClientRect();
  // The middle of the pixel that the pointer is on; browsers show pictures from whole pixels on.
  const x = (Math.floor(event.clientX - Math.round(box.left)) + 0.5) * canvas.width / box.width;
  const y = (Math.floor(event.clientY - Math.round(box.top)) + 0.5) * canvas.height / box.height;
  send(tag, number, x, y);
}

canvas.addEventListener("pointermove", (event) => {
  const parts = event.getCoalescedEvents ? event.getCoalescedEvents() : [];
  for (const part of parts.length ? parts : [event]) point(MOVED, part, 0);
});
canvas.addEventListener("pointerdown", (event) => {
  if (event.button > 2) return;
  canvas.focus();
  try { canvas.setPointerCapture(event.pointerId); } catch { /* the pointer is gone already */ }
  point(PRESSED, event, event.button);
  event.preventDefault();
});
canvas.addEventListener("pointerup", (event) => {
  if (event.button <= 2) point(RELEASED, event, event.button);
});
canvas.addEventListener("contextmenu", (event) => event.preventDefault());
canvas.addEventListener("wheel", (event) => {
  const notch = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 100 : 3;
  send(WHEEL, 0, -event.deltaY / notch, 0);
  event.preventDefault();
}, { passive: false });

document.addEventListener("keydown", (event) => {
  if (event.isComposing || event.ctrlKey || event.metaKey || event.target === take) return;
  const named = keys.indexOf(event.key);
  const numbered = /^F([0-9]+)$/.exec(event.key);
  if (named >= 0) send(KEY, named, 0, 0);
  // Reloading, the whole screen and the tools stay with the browser.
  else if (numbered && !["F5", "F11", "F12"].includes(event.key)) send(FUNCTION, Number(numbered[1]), 0, 0);
  else if ([...event.key].length === 1) send(CHARACTER, 0, event.key.codePointAt(0), 0);
  else return;
  event.preventDefault();
});

take.addEventListener("click", () => {
  socket.send(new Uint8Array([0]));
  canvas.focus();
});
