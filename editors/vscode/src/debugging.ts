// The debugger `kadr dap`.
import * as vscode from "vscode";
import { settings } from "./workspace";

export function debugging(): vscode.Disposable[] {
  return [
    vscode.debug.registerDebugAdapterDescriptorFactory("kadr", {
      createDebugAdapterDescriptor: (session) => {
        const { path, language } = settings(session.workspaceFolder?.uri);
        return new vscode.DebugAdapterExecutable(path, ["dap", "--lang", language]);
      },
    }),
    vscode.debug.registerDebugConfigurationProvider("kadr", {
      // F5 without a launch.json runs the open program; what a configuration leaves out comes from the settings.
      resolveDebugConfiguration: (folder, given) => {
        const config = given.type ? given : { type: "kadr", request: "launch", name: "Kadr", program: "${file}" };
        const { control, machine, setup } = settings(folder?.uri);
        for (const [name, value] of Object.entries({ control, machine, setup })) if (value) config[name] ??= value;
        return config;
      },
    }),
  ];
}
