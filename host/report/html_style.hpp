// The style of the report's page.
#pragma once

#include <string_view>

namespace sightline::report {

inline constexpr std::string_view page_style = R"(
:root { color-scheme: light dark; --ground: #fdfdfb; --ink: #1d1f21; --quiet: #5c6166; --rule: #d6d6cf;
  --band: #f3f3ed; --link: #0b5394; --good: #1b6e2d; --bad: #a61c1c; }
@media (prefers-color-scheme: dark) { :root { --ground: #17191b; --ink: #e4e4df; --quiet: #a2a7ab; --rule: #3a3e42;
  --band: #202326; --link: #8ab8ea; --good: #7fcf8e; --bad: #ff9a92; }
  img.drawing, .pair img { filter: invert(.9) hue-rotate(180deg); } }
* { box-sizing: border-box; }
html { scroll-padding-top: 4rem; }
body { margin: 0; background: var(--ground); color: var(--ink); overflow-wrap: break-word;
  font: 1rem/1.5 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
header { position: sticky; top: 0; z-index: 3; display: flex; flex-wrap: wrap; gap: .2rem 1.2rem; align-items: baseline;
  padding: .5rem 1.25rem; background: var(--band); border-bottom: 1px solid var(--rule); }
header h1 { font-size: 1.1rem; margin: 0; } header nav { display: flex; flex-wrap: wrap; gap: 0 1rem; font-size: .9rem; }
main, footer { margin: 0 auto; padding: .4rem 1.25rem 1rem; max-width: 76rem; }
h1, h2, h3, h4 { line-height: 1.25; font-weight: 650; }
h2 { font-size: 1.55rem; margin: 2.4rem 0 .8rem; padding-top: .7rem; border-top: 2px solid var(--ink); }
h3 { font-size: 1.15rem; margin: 1.6rem 0 .5rem; } h4 { font-size: 1rem; margin: 1.4rem 0 .4rem; }
main > section:first-of-type h2 { margin: .2rem 0 .6rem; border: 0; padding: 0; }
p { max-width: 48rem; margin: .5rem 0; }
.answers { display: grid; grid-template-columns: repeat(3, minmax(0, 1fr)); gap: .8rem; }
.answers > div { background: var(--band); border-left: 4px solid var(--link); padding: .4rem .8rem; }
.answers h3 { font-size: 1rem; margin: 0; } .answers p { margin: .1rem 0 0; font-size: .95rem; line-height: 1.4; }
.answer-plots { display: grid; grid-template-columns: repeat(2, minmax(0, 26.5rem)); gap: .5rem 1.5rem; align-items: start; margin-top: .6rem; }
.answer-plots svg { display: block; width: 100%; height: auto; }
a { color: var(--link); }
.contents ul { columns: 2; column-gap: 2.5rem; } .contents li { break-inside: avoid; }
summary { cursor: pointer; } summary h3, summary h4 { display: inline; margin: 0; }
details { margin: .5rem 0; } .chapter { padding: .3rem 0; border-bottom: 1px solid var(--rule); }
.wide { overflow: auto; max-width: 100%; width: fit-content; max-height: 34rem; margin: .5rem 0; border: 1px solid var(--rule); }
table { border-collapse: separate; border-spacing: 0; font-size: .88rem; line-height: 1.35; }
th, td { padding: .34rem .7rem; text-align: left; vertical-align: top; border-bottom: 1px solid var(--rule);
  background: var(--ground); }
thead th { position: sticky; top: 0; z-index: 1; vertical-align: bottom; border-bottom: 1.5px solid var(--ink);
  font-weight: 650; }
tbody th { position: sticky; left: 0; font-weight: 400; border-right: 1px solid var(--rule); max-width: 12rem; }
thead th:first-child { left: 0; z-index: 2; border-right: 1px solid var(--rule); }
tbody tr:nth-child(even) > * { background: var(--band); }
th small { display: block; font-weight: 400; color: var(--quiet); }
td { min-width: 3.2rem; max-width: 26rem; } tbody th:not(.n) { min-width: 6rem; }
.n { text-align: right; font-variant-numeric: tabular-nums; } td.n { white-space: nowrap; }
.good { color: var(--good); } .bad { color: var(--bad); font-weight: 650; }
pre { overflow: auto; max-height: 24rem; padding: .6rem .8rem; background: var(--band); font-size: .78rem; }
.files, .note, figcaption { color: var(--quiet); font-size: .86rem; }
.files a { margin-right: .8rem; }
figure { margin: 1rem 0; min-width: 0; }
figure img { display: block; max-width: 100%; height: auto; border: 1px solid var(--rule); border-radius: .25rem;
  background: #fff; }
figcaption { margin-top: .4rem; max-width: 48rem; } figcaption b { color: var(--ink); }
.pixelated { image-rendering: pixelated; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 32rem), 1fr)); gap: 0 1.5rem; }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(15.5rem, 1fr)); gap: 1.1rem; }
.gallery figure { margin: 0; } .gallery img { width: 100%; }
.panel { display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 27rem); gap: .5rem 2rem; padding: 1.1rem 0;
  border-bottom: 1px solid var(--rule); break-inside: avoid; }
.panel h3, .panel p:first-child { margin-top: 0; } .panel .pictures figure { margin: 0 0 .7rem; }
.panel .pictures img { width: 100%; } .panel:not(:has(.facts)) { grid-template-columns: minmax(0, 1fr) minmax(0, 15rem); }
.pictures:has(figure:nth-child(3)) { grid-template-columns: 1fr 1fr 1fr !important; }
.pictures:has(figure + figure) { display: grid; grid-template-columns: 1fr 1fr; gap: .8rem; align-content: start; }
.facts { display: flex; flex-wrap: wrap; gap: .5rem 1rem; margin: .6rem 0; }
.facts div { flex: 1 1 12rem; padding: .4rem .7rem; background: var(--band); border-left: 3px solid var(--link); }
.facts dt { font-size: .82rem; color: var(--quiet); } .facts dd { margin: 0; font-weight: 600; }
.filter { display: flex; flex-wrap: wrap; gap: .5rem 1rem; margin: .8rem 0; font-size: .92rem; }
fieldset { border: 1px solid var(--rule); min-width: 0; } .filter label { margin-right: .8rem; white-space: nowrap; }
section:has(.show-bad:checked) .card.right, section:has(.show-good:checked) .card.wrong { display: none; }
.deck { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 21rem), 1fr)); gap: 1rem; }
.card { padding: .7rem .9rem; border: 1px solid var(--rule); border-top: 3px solid var(--good); font-size: .88rem;
  min-width: 0; break-inside: avoid; overflow-wrap: anywhere; }
.card.wrong { border-top-color: var(--bad); } .card h4 { margin: 0 0 .4rem; }
.card dl { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: .15rem .7rem; margin: .4rem 0 0; }
.card dt { color: var(--quiet); max-width: 8rem; } .card dd { margin: 0; }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: .7rem; } .pair figure { margin: 0; } .pair img { width: 100%; }
footer { color: var(--quiet); font-size: .86rem; border-top: 1px solid var(--rule); }
@media (max-width: 56rem) { .panel { grid-template-columns: minmax(0, 1fr) !important; } .panel:not(:has(.facts)) img { max-width: 15rem; } }
@media (max-width: 40rem) { .answers, .answer-plots { grid-template-columns: minmax(0, 1fr); gap: .5rem; }
  header nav { flex-wrap: nowrap; overflow-x: auto; max-width: 100%; white-space: nowrap; }
  .contents ul { columns: 1; } header { position: static; } main, footer { padding: 1rem .8rem; }
  tbody th { max-width: 7.5rem; } .plots figure { overflow-x: auto; } .plots img { min-width: 34rem; } }
@media print { html { font-size: 9.5pt; } main { max-width: none; padding: 0; } header { position: static; }
  header nav, .contents, .filter, .files { display: none; } h2, h3, h4 { break-after: avoid; } tr, figure { break-inside: avoid; }
  .panel { grid-template-columns: minmax(0, 1fr) minmax(0, 18rem) !important; } thead { display: table-header-group; }
  .wide { overflow: visible; max-height: none; border: 0; } thead th, tbody th { position: static; }
  table { font-size: 6.5pt; } th, td { padding: .1rem .2rem; min-width: 0 !important; } thead th { overflow-wrap: anywhere; }
  .many td { font-size: 5pt; white-space: normal !important; overflow-wrap: anywhere; } pre { max-height: none; white-space: pre-wrap; } }
)";

}  // namespace sightline::report
