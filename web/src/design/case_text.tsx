// The case file as text, beside the form: editing either changes the other.

import { defaultKeymap, history, historyKeymap } from "@codemirror/commands";
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { lintGutter, setDiagnostics, type Diagnostic } from "@codemirror/lint";
import { Annotation, EditorState, type ChangeSpec } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";
import { effect } from "@preact/signals";
import type { JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";
import type { Mistake } from "../api/types";
import { design, opened, setText, text } from "../state/design";

const fromOutside = Annotation.define<boolean>();

const colours = HighlightStyle.define([
  { tag: tags.comment, class: "toml-comment" },
  { tag: tags.string, class: "toml-string" },
  { tag: [tags.number, tags.bool], class: "toml-number" },
  { tag: tags.propertyName, class: "toml-key" },
  { tag: tags.atom, class: "toml-section" },
]);

const extensions = [
  lineNumbers(),
  history(),
  drawSelection(),
  highlightActiveLine(),
  EditorView.lineWrapping,
  lintGutter(),
  StreamLanguage.define(toml),
  syntaxHighlighting(colours),
  keymap.of([...defaultKeymap, ...historyKeymap]),
  EditorView.contentAttributes.of({ "aria-label": "Case file" }),
  EditorView.updateListener.of((update) => {
    const isOurs = update.transactions.some((transaction) => transaction.annotation(fromOutside) === true);
    if (update.docChanged && !isOurs) setText(update.state.doc.toString());
  }),
];

const newState = (): EditorState => EditorState.create({ doc: text.peek(), extensions });

/** The one piece in which two texts differ; what is around it, and the cursor there, stays. */
function changeBetween(before: string, after: string): ChangeSpec {
  const shorter = Math.min(before.length, after.length);
  let start = 0;
  while (start < shorter && before[start] === after[start]) start++;
  let end = 0;
  while (end < shorter - start && before[before.length - 1 - end] === after[after.length - 1 - end]) end++;
  return { from: start, to: before.length - end, insert: after.slice(start, after.length - end) };
}

function diagnosticsOf(state: EditorState, mistakes: Mistake[]): Diagnostic[] {
  return mistakes.flatMap(({ line: number, message }) => {
    if (number === null || number > state.doc.lines) return [];
    const line = state.doc.line(number);
    const start = line.from + (line.text.length - line.text.trimStart().length);
    return [{ from: start, to: line.to, severity: "error", message } satisfies Diagnostic];
  });
}

function follow(view: EditorView): () => void {
  let shown = opened.peek();
  return effect(() => {
    const now = text.value;
    if (shown !== opened.value) {
      shown = opened.value;
      view.setState(newState());
    }
    const before = view.state.doc.toString();
    if (before !== now) view.dispatch({ changes: changeBetween(before, now), annotations: fromOutside.of(true) });
    if (design.value?.text === now) {
      view.dispatch(setDiagnostics(view.state, diagnosticsOf(view.state, design.value.mistakes)));
    }
  });
}

export function CaseText(): JSX.Element {
  const place = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const view = new EditorView({ state: newState(), parent: place.current as HTMLDivElement });
    const stop = follow(view);
    return () => {
      stop();
      view.destroy();
    };
  }, []);
  return <div class="case-text" ref={place} data-test="case-text" />;
}
