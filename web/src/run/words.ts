// How the page Run says things.

import type { RunHead, RunStatus } from "../api/types";
import { figures } from "../parts/curve_data";

const kAtTarget = 5e-4; // so near to it a strain counts as reached

const hasReachedTarget = (run: RunHead): boolean => run.strain >= run.target_strain - kAtTarget;

const words: Record<RunStatus, string> = {
  waiting: "waits for its turn",
  running: "running",
  paused: "paused",
  completed: "completed",
  interrupted: "interrupted",
  failed: "failed",
  damaged: "damaged",
};

/** A run that has reached its strain still draws pictures and writes its report, and takes no commands any more. */
export const isFinishing = (run: RunHead): boolean => run.status === "running" && hasReachedTarget(run);

export const statusText = (run: RunHead): string => (isFinishing(run) ? "finishing" : words[run.status]);

/** "8 s", "3 min 20 s", "2 h 5 min" */
export function durationText(seconds: number): string {
  const whole = Math.round(seconds);
  if (whole < 60) return `${whole} s`;
  if (whole < 600) return `${Math.floor(whole / 60)} min ${whole % 60} s`;
  const minutes = Math.round(seconds / 60);
  return minutes < 60 ? `${minutes} min` : `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

/** 0.0834 -> "8.3 %" */
export function strainText(strain: number): string {
  return `${(100 * strain).toFixed(1)} %`;
}

export function shareText(share: number | null): string {
  return share === null ? "–" : `${figures(100 * share)} %`;
}

export function quantityText(value: number | null | undefined, unit: string): string {
  return value === null || value === undefined ? "–" : `${figures(value)} ${unit}`;
}

/** "8.3 of 22 % strain, 3 min left" */
export function progressText(run: RunHead): string {
  const target = Number((100 * run.target_strain).toFixed(1));
  const strain = hasReachedTarget(run) ? `${target} % strain` : `${(100 * run.strain).toFixed(1)} of ${target} % strain`;
  if (run.status === "running" && run.seconds_left !== null) return `${strain}, ${durationText(run.seconds_left)} left`;
  return run.seconds > 0 ? `${strain}, ${durationText(run.seconds)}` : strain;
}
