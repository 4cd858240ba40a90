// SPDX-License-Identifier: MIT
import './maps'
import './controls'
import './lights'
import './quality'
import './outputs'
import './explain'
import './live'
import { redraw } from './picture'

void redraw()
