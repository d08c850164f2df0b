// From the disk, a browser shows only the page that is one file (open_in_kadr.py).
if (location.protocol === "file:")
  for (const link of document.querySelectorAll("a.open-in-kadr")) link.href = link.href.replace("kadr/index.html#", "kadr/kadr.html#");
