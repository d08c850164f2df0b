// Messages about files of the served folder.
export interface Example {
  name: string;
  control: string;
  title: string;
}

/// `trash`: its place in the trash; `deleted`: when, s since 1970, 0: not known.
export interface TrashEntry {
  trash: string;
  file: string;
  size: number;
  deleted: number;
}

export interface FileQuestions {
  digest: [{ file: string; known?: string }, { digest: string | null }];
  rename: [{ file: string; to: string }, object];
  copy: [{ file: string; to: string }, { digest: string }];
  delete: [{ file: string }, { trash: string }];
  restore: [{ trash: string; file: string }, object];
  trash: [object, { entries: TrashEntry[]; more?: boolean }];
  empty_trash: [{ trash?: string }, { deleted: number }];
  new_program: [{ control: string }, { text: string }];
  examples: [object, { examples: Example[] }];
  take_example: [{ name: string }, { file: string; control: string; machine?: string; setup?: string }];
}
