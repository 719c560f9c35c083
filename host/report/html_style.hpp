// The style of the report's page.
#pragma once

#include <string_view>

namespace sightline::report {

inline constexpr std::string_view page_style = R"(
:root { color-scheme: light dark; --ground: #fdfdfb; --ink: #1d1f21; --quiet: #5c6166; --rule: #d6d6cf;
  --band: #f3f3ed; --link: #0b5394; --good: #1b6e2d; --bad: #a61c1c; --frame: #fff; }
@media (prefers-color-scheme: dark) { :root { --ground: #17191b; --ink: #e4e4df; --quiet: #a2a7ab; --rule: #3a3e42;
  --band: #202326; --link: #8ab8ea; --good: #7fcf8e; --bad: #ff9a92; --frame: #fff; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.25rem 5rem; max-width: 76rem; background: var(--ground); color: var(--ink);
  font: 1rem/1.55 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
h1, h2, h3 { line-height: 1.2; font-weight: 650; }
h1 { font-size: 2.1rem; margin: 0 0 1rem; }
h2 { font-size: 1.55rem; margin: 3.5rem 0 1rem; padding-top: .8rem; border-top: 2px solid var(--ink); }
h3 { font-size: 1.15rem; margin: 2.4rem 0 .6rem; }
p { max-width: 48rem; margin: .6rem 0; }
a { color: var(--link); }
nav { margin: 1.5rem 0; padding: .8rem 1.2rem; background: var(--band); border-radius: .4rem; }
nav ol, nav ul { margin: .3rem 0; padding-left: 1.3rem; }
nav > ol > li { margin: .3rem 0; font-weight: 650; }
nav ul { font-weight: 400; columns: 2; column-gap: 2.5rem; }
nav ul li { break-inside: avoid; }
.wide { overflow-x: auto; margin: .5rem 0; }
table { border-collapse: collapse; font-size: .88rem; line-height: 1.35; }
th, td { padding: .34rem .7rem; text-align: left; vertical-align: top; border-bottom: 1px solid var(--rule); }
thead th { vertical-align: bottom; border-bottom: 1.5px solid var(--ink); font-weight: 650; }
tbody tr:nth-child(even) { background: var(--band); }
th small { display: block; font-weight: 400; color: var(--quiet); }
td { min-width: 3.2rem; max-width: 26rem; } td:first-child:not(.n) { min-width: 7rem; }
.n { text-align: right; font-variant-numeric: tabular-nums; } td.n { white-space: nowrap; }
.good { color: var(--good); } .bad { color: var(--bad); font-weight: 650; }
details { margin: .3rem 0; } summary { cursor: pointer; font-family: ui-monospace, "DejaVu Sans Mono", monospace;
  font-size: .9rem; }
pre { overflow: auto; max-height: 24rem; padding: .6rem .8rem; background: var(--band); font-size: .78rem; }
.files, .note, figcaption { color: var(--quiet); font-size: .86rem; }
.files a { margin-right: .8rem; }
figure { margin: 1rem 0; }
figure img { display: block; max-width: 100%; height: auto; border: 1px solid var(--rule); border-radius: .25rem;
  background: var(--frame); }
figcaption { margin-top: .4rem; max-width: 48rem; }
figcaption b { color: var(--ink); }
.pixelated { image-rendering: pixelated; }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(15.5rem, 1fr)); gap: 1.1rem; }
.gallery figure { margin: 0; } .gallery img { width: 100%; }
footer { margin-top: 4rem; color: var(--quiet); font-size: .86rem; border-top: 1px solid var(--rule); }
@media (max-width: 40rem) { nav ul { columns: 1; } }
@media print { body { max-width: none; padding: 0; font-size: 9.5pt; } nav ul { columns: 2; }
  h2 { break-before: page; } h3 { break-after: avoid; } tr, figure { break-inside: avoid; }
  thead { display: table-header-group; } .wide { overflow: visible; } table { font-size: 7.5pt; } .files { display: none; } }
)";

}  // namespace sightline::report
