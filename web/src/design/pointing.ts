// Which parameter the user looks at: the drawing and the form show it to each other.

import { computed, signal } from "@preact/signals";

export const focused = signal<string | null>(null); // key of the field with the focus
export const hovered = signal<string | null>(null); // key of the field or dimension under the pointer
export const lit = computed(() => hovered.value ?? focused.value);

/** A wish to go to a field, which the form fulfils: it opens the field's group first. */
export const wanted = signal<{ key: string } | null>(null);

export function goToField(key: string): void {
  wanted.value = { key };
}

export const fieldId = (key: string): string => `field-${key}`;
