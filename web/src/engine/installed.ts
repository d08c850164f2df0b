// The page as an installed program: a service worker keeps its parts, so that it opens without a network.

/// A page that was opened from the disk is a file, and needs no service worker.
export function listen_installed(): void {
  if (!("serviceWorker" in navigator) || location.protocol === "file:" || document.getElementById("kadr-engine-wasm"))
    return;
  navigator.serviceWorker.register("offline.js").catch(() => undefined); // without it the page needs the network
}

interface LaunchQueue {
  setConsumer(take: (of: { files?: FileSystemFileHandle[] }) => void): void;
}

/// The files with which the system has opened the installed page (Chromium; manifest.webmanifest says which).
export function on_launch(take: (files: File[]) => void): void {
  const { launchQueue } = window as unknown as { launchQueue?: LaunchQueue };
  launchQueue?.setConsumer(({ files }) => {
    if (files?.length) void Promise.all(files.map((handle) => handle.getFile())).then(take);
  });
}
