// Changes what is shown only where it differs: elements that are updated many times a second stay the same, so that a
// finger that holds one is not lost, and little is laid out and painted.
/// Writes a text only where it has changed.
export function write(e: Element, text: string): void {
  if (e.textContent !== text) e.textContent = text;
}
export function mark(e: Element, name: string, on: boolean): void {
  if (e.classList.contains(name) !== on) e.classList.toggle(name, on);
}
export function set(e: Element, name: string, value: string): void {
  if (e.getAttribute(name) !== value) e.setAttribute(name, value);
}
export function enable(e: HTMLButtonElement | HTMLInputElement | HTMLSelectElement, may: boolean): void {
  if (e.disabled === may) e.disabled = !may;
}
