import type { Application } from "./application";
import { sourceOf } from "./file_source";
import { type FileUse, fileUse } from "./file_use";
import type { CommandInfo, Item, PageApi, State } from "./page_api";

/** `window.marey`. What is called before the page has started waits, or throws where it must answer at once. */
export function makePageApi(application: Application, ready: Promise<void>, started: Promise<void>): PageApi {
  const open = async (name: string, data: string | Uint8Array | ArrayBuffer | Blob, use?: FileUse): Promise<State> => {
    await started;
    await application.open(name, sourceOf(new Blob([data as BlobPart])), use);
    application.loop.drawNow();
    return application.state();
  };
  return {
    ready,
    open: (name, data) => open(name, data),
    openOther: (name, data) => open(name, data, fileUse.otherClip),
    save: () => application.program.save(),
    state: () => application.state(),
    commands: () => application.program.commands() as CommandInfo[],
    async command(id, args) {
      await started;
      const answer = application.program.runCommand(id, args);
      application.loop.drawNow();
      application.loop.request();
      if (isRefusal(answer)) throw new Error(answer.error);
      return answer;
    },
    memory: () => application.program.memory(),
    ui: { items: () => application.program.items() as Item[] },
  };
}

function isRefusal(answer: unknown): answer is { error: string } {
  return typeof answer === "object" && answer !== null && typeof (answer as { error?: unknown }).error === "string";
}
