// SPDX-License-Identifier: MIT
// workflows.mjs NPM FILE...: what GitHub's own parser (npm's @actions/workflow-parser, below NPM) makes of workflows, as JSON: the errors and
// the steps of each.
import {readFile} from "node:fs/promises";
import {register} from "node:module";
import {basename, resolve} from "node:path";
import {pathToFileURL} from "node:url";

// The package imports its schema as browsers' bundlers take JSON; node wants a word more, so a hook gives it a module.
const hook = `import {readFile} from "node:fs/promises";
export async function load(url, context, next) {
    if (!url.endsWith(".json")) return next(url, context);
    return {format: "module", shortCircuit: true, source: "export default " + await readFile(new URL(url), "utf8")};
}`;
register("data:text/javascript," + encodeURIComponent(hook));
const [npm, ...files] = process.argv.slice(2);
const parser = pathToFileURL(resolve(npm, "node_modules/@actions/workflow-parser/dist/index.js"));
const {convertWorkflowTemplate, NoOperationTraceWriter, parseWorkflow} = await import(parser);

const found = {};
for (const file of files) {
    const name = basename(file);
    const {context, value} = parseWorkflow({name, content: await readFile(file, "utf8")}, new NoOperationTraceWriter());
    const template = value && await convertWorkflowTemplate(context, value);
    const jobs = template?.jobs ?? [];
    found[name] = {
        errors: context.errors.getErrors().map((error) => error.message),
        steps: jobs.flatMap((job) => job.steps ?? []).map(({run, uses}) => ({run: run && `${run}`, uses: uses && `${uses}`})),
    };
}
console.log(JSON.stringify(found));
