// The frame of the page: name, pages, theme, notes.

import type { JSX } from "preact";
import { DesignPage } from "../design/design_page";
import { ExplorePage } from "../explore/explore_page";
import { ExportPage } from "../export/export_page";
import { RunPage } from "../run/run_page";
import { closeNote, notes, parameters, program } from "../state/program";
import { addressOf, pageNames, route, type PageName } from "../state/route";
import { isLinked } from "../state/runs";
import { theme, toggleTheme } from "../state/theme";

const titles: Record<PageName, string> = { design: "Design", run: "Run", explore: "Explore", export: "Export" };
const pages: Record<PageName, () => JSX.Element> = {
  design: DesignPage,
  run: RunPage,
  explore: ExplorePage,
  export: ExportPage,
};

function TopBar(): JSX.Element {
  return (
    <header class="top-bar">
      <span class="name">KnitMech</span>
      <nav aria-label="Pages">
        {pageNames.map((name) => (
          <a key={name} href={addressOf(name)} aria-current={route.value.page === name ? "page" : undefined}>
            {titles[name]}
          </a>
        ))}
      </nav>
      <span class="spread" />
      {isLinked.value ? null : (
        <span class="wrong" role="status">
          No link to the program
        </span>
      )}
      <span class="quiet folder" title="Cases and runs are in this folder">
        {program.value?.folder ?? ""}
      </span>
      <button
        type="button"
        class="plain"
        onClick={toggleTheme}
        aria-label={theme.value === "light" ? "Dark colours" : "Light colours"}
        title={theme.value === "light" ? "Dark colours" : "Light colours"}
      >
        {theme.value === "light" ? "☾" : "☀"}
      </button>
    </header>
  );
}

function Notes(): JSX.Element {
  return (
    <div class="notes" aria-live="polite">
      {notes.value.map((note) => (
        <div key={note.id} class={note.isWrong ? "note wrong" : "note"} role={note.isWrong ? "alert" : "status"}>
          <span>{note.text}</span>
          <button type="button" class="plain" aria-label="Close this note" onClick={() => closeNote(note.id)}>
            ×
          </button>
        </div>
      ))}
    </div>
  );
}

export function Shell(): JSX.Element {
  const Page = pages[route.value.page];
  return (
    <>
      <TopBar />
      <main class={`page-${route.value.page}`}>{program.value && parameters.value ? <Page /> : null}</main>
      <Notes />
    </>
  );
}
