// Search without a server. From file:// a browser neither starts a worker nor reads search_index.json, so the index is loaded as a script
// (search_index.js, written by dev/site), and the theme's search runs in a hidden frame that behaves like a worker. The theme's worker
// recognises such a frame by the name IFrameWorker in its parent.
var __search;
if (location.protocol === 'file:') {
  const index = new URL('search/search_index.js', document.currentScript.src);
  __search = {
    index: new Promise((resolve) => {
      window.__kadr_index = resolve;
      addEventListener('DOMContentLoaded', () => load(document, index));
    }),
  };

  function load(into, address) {
    return new Promise((resolve, reject) => {
      const script = into.createElement('script');
      Object.assign(script, { src: address, onload: resolve, onerror: reject });
      into.head.append(script);
    });
  }

  window.IFrameWorker = window.Worker = class extends EventTarget {
    constructor(address) {
      super();
      const frame = document.createElement('iframe');
      frame.hidden = true;
      document.body.append(frame);
      const inside = frame.contentWindow;
      inside.postMessage = (data) => this.dispatchEvent(new MessageEvent('message', { data }));
      inside.importScripts = (...scripts) =>
        scripts.reduce((before, script) => before.then(() => load(inside.document, script)), Promise.resolve());
      this.inside = inside;
      this.ready = load(inside.document, new URL(address, location));
    }
    postMessage(data) {
      this.ready.then(() => this.inside.dispatchEvent(new this.inside.MessageEvent('message', { data })));
    }
  };
}
