// SPDX-License-Identifier: MIT
// The course as a site. What is generated into docs/generated and docs/public comes from docs/generate.py.
import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { dirname, relative, resolve } from 'node:path'
import { defineConfig } from 'vitepress'

const docs = resolve(import.meta.dirname, '..')
const root = resolve(docs, '..')

function titleOf(page: string): string {
  return /^# (.+)$/m.exec(readFileSync(resolve(docs, `${page}.md`), 'utf8'))![1].replaceAll('`', '')
}

function links(pages: string[]) {
  return pages
    .filter((page) => existsSync(resolve(docs, `${page}.md`)))
    .map((page) => ({ text: titleOf(page), link: `/${page}` }))
}

const chapters = readdirSync(resolve(docs, 'chapters'))
  .sort()
  .map((file) => `chapters/${file.replace('.md', '')}`)

export default defineConfig({
  lang: 'en',
  title: 'Stagelight',
  description: 'A course in C++ and OpenCL: a Whitted ray tracer in eleven stages, each proven right',
  outDir: '../build/docs/site',
  cacheDir: '../build/docs/cache',
  srcExclude: ['generated/**', 'node_modules/**'],
  metaChunk: true,
  // A ball, and the light on it
  head: [['link', { rel: 'icon', href: 'data:image/svg+xml,' + encodeURIComponent(
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 16"><circle cx="8" cy="8" r="7" fill="#b3261e"/>'
    + '<circle cx="5.5" cy="5" r="2" fill="#fff"/></svg>') }]],
  markdown: {
    math: true,
    theme: { light: 'github-light-high-contrast', dark: 'github-dark-high-contrast' },
    config(md) {
      // A chapter's listing of a kernel has no more of it than its stage has learnt.
      md.core.ruler.before('normalize', 'lessons', (state) => {
        const [, stage] = /chapters\/(\w+)\.md$/.exec(state.env.path ?? '') ?? []
        if (!stage) return
        state.src = state.src.replace(/^<<< \.\.\/\.\.\/([^#]+)/gm, (listing, file) =>
          existsSync(resolve(docs, 'generated/lessons', stage, file))
            ? `<<< ../generated/lessons/${stage}/${file}` : listing)
      })
      // A table's empty corner is no heading.
      md.core.ruler.push('corners', (state) => {
        state.tokens.forEach((token, i) => {
          if (token.type === 'th_open' && !state.tokens[i + 1].content) {
            token.tag = state.tokens[i + 2].tag = 'td'
          }
        })
      })
      // Indented blocks are text: as such they can be scrolled by keys.
      md.core.ruler.push('blocks', (state) => {
        for (const token of state.tokens) {
          if (token.type === 'code_block') Object.assign(token, { type: 'fence', tag: 'code', info: 'text' })
        }
      })
      // A link to a file outside docs/ leads to the copy that docs/generate.py makes of it.
      md.core.ruler.push('sources', (state) => {
        for (const token of state.tokens.flatMap((token) => [token, ...(token.children ?? [])])) {
          const href = token.type === 'link_open' ? token.attrGet('href') : null
          if (!href || /^(\w+:|#|\/)/.test(href)) continue
          const target = relative(root, resolve(dirname(state.env.path), href.split('#')[0]))
          if (target.startsWith('docs/')) continue
          token.attrSet('href', `/sources/${target}.txt`)
          token.attrSet('target', '_self')
        }
      })
    },
  },
  themeConfig: {
    search: { provider: 'local' },
    outline: [2, 3],
    nav: [
      { text: 'Start here', link: '/start' },
      { text: 'Speed against accuracy', link: '/chart' },
      { text: 'Where methods fail', link: '/stability/' },
    ],
    sidebar: [
      { text: 'The course', items: [...links(['start']), ...links(chapters)] },
      {
        text: 'Beside it',
        items: links(['judging', 'chart', 'stability/index', 'opencl', 'opencl-vectors', 'debugging', 'paper', 'glossary']),
      },
      {
        text: 'Reference',
        items: links(['other-systems', 'window', 'scene-format', 'methods', 'shading', 'architecture', 'benchmarks',
          'mutants', 'pov-ray', 'other-readers', 'gl-sharing-layer', 'implementations']),
      },
    ],
  },
})
