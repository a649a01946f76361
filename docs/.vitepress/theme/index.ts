// SPDX-License-Identifier: MIT
import DefaultTheme from 'vitepress/theme-without-fonts'
import type { Theme } from 'vitepress'
import Compare from './Compare.vue'
import Picture from './Picture.vue'
import './style.css'

export default {
  extends: DefaultTheme,
  enhanceApp({ app }) {
    app.component('Compare', Compare).component('Picture', Picture)
  },
} satisfies Theme
