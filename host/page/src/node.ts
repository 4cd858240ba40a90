// SPDX-License-Identifier: MIT
// What the tests run in node.
export { Engine } from './engine'
export { readPng, writePng } from './png'
export { commandLine, fragmentOf, stateOfFragment, stateOfWords, wordsOf } from './words'
