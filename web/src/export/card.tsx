// One kind of export: what it is, its buttons, and how the same is done in a terminal.

import { useSignal } from "@preact/signals";
import type { ComponentChildren, JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";

/** An argument as a shell takes it. */
export function quoted(argument: string): string {
  return /^[\w./:=@%+,-]+$/.test(argument) ? argument : `'${argument.replaceAll("'", "'\\''")}'`;
}

const kShown = 2000; // ms in which the button says that it has copied

/** Text with a button that copies it; where the browser does not let it, the text is selected for Ctrl+C. */
export function Copied({ text, name }: { text: string; name: string }): JSX.Element {
  const code = useRef<HTMLElement>(null);
  const said = useSignal("Copy");
  useEffect(() => {
    if (said.value === "Copy") return;
    const timer = setTimeout(() => (said.value = "Copy"), kShown);
    return () => clearTimeout(timer);
  }, [said.value]);
  const copy = async (): Promise<void> => {
    try {
      await navigator.clipboard.writeText(text);
      said.value = "Copied";
    } catch {
      getSelection()?.selectAllChildren(code.current as HTMLElement);
      said.value = "Ctrl+C";
    }
  };
  return (
    <div class="copied">
      <code ref={code}>{text}</code>
      <button type="button" onClick={() => void copy()} aria-label={`Copy ${name}`}>
        {said.value}
      </button>
    </div>
  );
}

interface Props {
  title: string;
  about: string;
  children: ComponentChildren;
  trouble?: string;
  terminal?: string; // the words before the command; left out: the usual ones
  command: string;
  size?: "double" | "wide"; // left out: a third of the page
}

export function Card({ title, about, children, trouble, terminal, command, size }: Props): JSX.Element {
  return (
    <section class={`panel card ${size ?? ""}`} aria-label={title}>
      <h2>{title}</h2>
      <p class="about">{about}</p>
      <div class="body">{children}</div>
      {trouble === undefined || trouble === "" ? null : (
        <p class="wrong" role="alert">
          {trouble}
        </p>
      )}
      <div class="terminal">
        <span class="quiet">{terminal ?? "The same in a terminal:"}</span>
        <Copied text={command} name={`the command of ${title}`} />
      </div>
    </section>
  );
}
