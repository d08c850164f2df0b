/// What a token is, for its colour; "" has none.
export type TokenKind =
  "comment" | "label" | "motion" | "function" | "axis" | "feed" | "variable" | "program" | "keyword" | "number" | "";
