// Prints the values of every call in the format of the host program.
import { readFileSync } from "node:fs";

const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]));
const { single, double, single_count, double_count, input_count } = instance.exports;
const hex = (value, digits) => BigInt.asUintN(4 * digits, BigInt(value)).toString(16).padStart(digits, "0");
for (const [name, run, count, digits] of [
  ["single", single, single_count(), 8],
  ["double", double, double_count(), 16],
]) {
  for (let call = 0; call < count; call += 1) {
    for (let input = 0; input < input_count(); input += 1) {
      const values = [0, 1].map((which) => hex(run(call, input, which), digits));
      console.log(name, call, input, ...values);
    }
  }
}
