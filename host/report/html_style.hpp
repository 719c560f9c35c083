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
html { scroll-padding-top: 4rem; }
body { margin: 0; background: var(--ground); color: var(--ink);
  font: 1rem/1.5 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
header { position: sticky; top: 0; z-index: 2; display: flex; flex-wrap: wrap; gap: .2rem 1.2rem; align-items: baseline;
  padding: .5rem 1.25rem; background: var(--band); border-bottom: 1px solid var(--rule); }
header h1 { font-size: 1.1rem; margin: 0; } header nav { display: flex; flex-wrap: wrap; gap: 0 1rem; font-size: .9rem; }
main, footer { margin: 0 auto; padding: 1rem 1.25rem; max-width: 76rem; }
h1, h2, h3 { line-height: 1.2; font-weight: 650; }
h2 { font-size: 1.55rem; margin: 2.6rem 0 .8rem; padding-top: .7rem; border-top: 2px solid var(--ink); }
h3 { font-size: 1.1rem; margin: 1.6rem 0 .5rem; }
p { max-width: 48rem; margin: .5rem 0; }
a { color: var(--link); }
.contents ul { columns: 2; column-gap: 2.5rem; } .contents li { break-inside: avoid; }
summary h3 { display: inline; margin: 0; }
.wide { overflow: auto; max-height: 34rem; margin: .5rem 0; }
table { border-collapse: collapse; font-size: .88rem; line-height: 1.35; }
th, td { padding: .34rem .7rem; text-align: left; vertical-align: top; border-bottom: 1px solid var(--rule); }
thead th { position: sticky; top: 0; background: var(--ground); vertical-align: bottom;
  box-shadow: inset 0 -1.5px var(--ink); font-weight: 650; }
tbody tr:nth-child(even) { background: var(--band); }
th small { display: block; font-weight: 400; color: var(--quiet); }
td { min-width: 3.2rem; max-width: 26rem; } td:first-child:not(.n) { min-width: 7rem; }
.n { text-align: right; font-variant-numeric: tabular-nums; } td.n { white-space: nowrap; }
.good { color: var(--good); } .bad { color: var(--bad); font-weight: 650; }
details { margin: .5rem 0; } summary { cursor: pointer; }
pre { overflow: auto; max-height: 24rem; padding: .6rem .8rem; background: var(--band); font-size: .78rem; }
.files, .note, figcaption { color: var(--quiet); font-size: .86rem; }
.files a { margin-right: .8rem; }
figure { margin: 1rem 0; }
figure img { display: block; max-width: 100%; height: auto; border: 1px solid var(--rule); border-radius: .25rem;
  background: var(--frame); }
figcaption { margin-top: .4rem; max-width: 48rem; }
figcaption b { color: var(--ink); }
.pixelated { image-rendering: pixelated; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 32rem), 1fr)); gap: 0 1.5rem; }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(15.5rem, 1fr)); gap: 1.1rem; }
.gallery figure { margin: 0; } .gallery img { width: 100%; } .strips figure { margin: .6rem 0; }
footer { color: var(--quiet); font-size: .86rem; border-top: 1px solid var(--rule); }
@media (max-width: 40rem) { .contents ul { columns: 1; } header { position: static; } }
@media print { body { font-size: 9.5pt; } main { max-width: none; padding: 0; } header { position: static; }
  h2 { break-before: page; } h3 { break-after: avoid; } tr, figure { break-inside: avoid; }
  thead { display: table-header-group; } .wide { overflow: visible; max-height: none; } thead th { position: static; } table { font-size: 7.5pt; } .files { display: none; } }
)";

}  // namespace sightline::report
