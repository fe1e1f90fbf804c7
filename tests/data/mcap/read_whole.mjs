// Reads an MCAP file twice with @mcap/core, by its index and from end to end with all checksums, and checks each message
// against its JSON Schema. Prints one JSON object: the messages of each topic, each way, and the first that is invalid.
import { open } from "node:fs/promises";
import { createReadStream } from "node:fs";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import Ajv from "ajv";

const path = process.argv[2];
const file = await open(path);
const { size } = await file.stat();
const text = new TextDecoder();
const told = { indexed: {}, streamed: {}, invalid: "" };

function count(topics, topic) {
  topics[topic] = (topics[topic] ?? 0) + 1;
}

const readable = {
  size: async () => BigInt(size),
  read: async (offset, length) => {
    const buffer = new Uint8Array(Number(length));
    const { bytesRead } = await file.read(buffer, 0, buffer.length, Number(offset));
    if (bytesRead !== buffer.length) throw new Error(`no ${length} bytes at ${offset}`);
    return buffer;
  },
};
const indexed = await McapIndexedReader.Initialize({ readable });
const ajv = new Ajv({ strict: false });
const checks = new Map();
for (const [id, schema] of indexed.schemasById) checks.set(id, ajv.compile(JSON.parse(text.decode(schema.data))));
let last = 0n;
for await (const message of indexed.readMessages({ validateCrcs: true })) {
  const channel = indexed.channelsById.get(message.channelId);
  if (message.logTime < last) throw new Error("the index is out of order");
  last = message.logTime;
  count(told.indexed, channel.topic);
  const check = checks.get(channel.schemaId);
  if (!check(JSON.parse(text.decode(message.data))) && told.invalid === "")
    told.invalid = `${channel.topic}: ${JSON.stringify(check.errors)}`;
}

const streamed = new McapStreamReader({ validateCrcs: true });
const topics = new Map();
for await (const bytes of createReadStream(path)) {
  streamed.append(bytes);
  for (let record = streamed.nextRecord(); record; record = streamed.nextRecord()) {
    if (record.type === "Channel") topics.set(record.id, record.topic);
    if (record.type === "Message") count(told.streamed, topics.get(record.channelId));
  }
}
if (!streamed.done()) throw new Error("the file does not end");
console.log(JSON.stringify(told));
process.exit(0);
