// Messages of docs/panel-protocol.md: the forms that several messages share.
export type Language = "en" | "ru";
export type Box = [number[], number[]];
export type Axes = Record<string, number>;

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
export type JsonTable = { [key: string]: Json };
