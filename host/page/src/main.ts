// SPDX-License-Identifier: MIT
import './tabs'
import './stage'
import './sun'
import './presets'
import './controls'
import './maps'
import './lights'
import './quality'
import './outputs'
import './explain'
import './live'
import { redraw } from './picture'

void redraw()
