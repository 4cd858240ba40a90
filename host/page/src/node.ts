// SPDX-License-Identifier: MIT
// What the tests run in node.
export { default as lists } from 'glint:lists'
export { Engine } from './engine'
export { namedBy, together } from './obj'
export { filters, Pico, sentences, Trouble } from './pico'
export { readPng, writePng } from './png'
export { commandLine, fragmentOf, meshOnDevice, onDevice, stateOfFragment, stateOfWords, white, whiteName, wordsOf } from './words'
