// SPDX-License-Identifier: BSD-3-Clause
// How the page of a sweep looks and what it does by itself.
#pragma once

namespace vdamf
{
/// Light and dark by the reader's choice; charts drawn on white are inverted in the dark.
inline constexpr const char* kPageStyle = R"(
:root{--bg:#fff;--fg:#1d2329;--muted:#5c6772;--line:#dfe4e8;--card:#f6f8f9;--accent:#0072b2;
--best:#d55e00;color-scheme:light dark}
@media(prefers-color-scheme:dark){:root{--bg:#15191d;--fg:#e4e8eb;--muted:#98a3ad;--line:#333b43;
--card:#1d2328;--accent:#56b4e9;--best:#f0a05a}.plot svg{filter:invert(1) hue-rotate(180deg);mix-blend-mode:screen}}
*{box-sizing:border-box}
body{margin:0 auto;max-width:1240px;padding:24px;background:var(--bg);color:var(--fg);
font:15px/1.5 system-ui,sans-serif}
h1{font-size:26px;margin:0}h2{font-size:19px;margin:36px 0 6px}
p{margin:4px 0 12px;color:var(--muted);max-width:80ch}
.cards{display:flex;flex-wrap:wrap;gap:12px;margin:18px 0}
.card{background:var(--card);border:1px solid var(--line);border-radius:8px;padding:12px 16px}
.card b{display:block;font-size:20px;font-weight:600}.card span{color:var(--muted);font-size:13px}
.card.best{border-color:var(--best)}code{font:13px ui-monospace,monospace}
.plots{display:flex;flex-wrap:wrap;gap:14px}.plots>div{max-width:100%;overflow-x:auto}
svg{max-width:100%;height:auto;font:12px system-ui,sans-serif;fill:currentColor}
.plot svg{fill:#1d2329}.map svg{overflow:visible}
.grid{stroke:var(--line);fill:none}.front{stroke:var(--best);stroke-width:2;fill:none}
.point{fill:var(--accent);fill-opacity:.75;cursor:pointer}.point.best{fill:var(--best);fill-opacity:1}
.on-dark{fill:#fff}.on-light{fill:#111}
.scroll{overflow-x:auto;max-height:560px;border:1px solid var(--line);border-radius:8px}
table{border-collapse:collapse;width:100%;font-size:13px;font-variant-numeric:tabular-nums}
th,td{padding:5px 10px;text-align:right;white-space:nowrap;border-bottom:1px solid var(--line)}
th.text,td.text{text-align:left}
th{white-space:normal;vertical-align:bottom}
thead th{position:sticky;top:0;background:var(--card);cursor:pointer;user-select:none}
thead th[aria-sort]{color:var(--accent)}
th[aria-sort=ascending]::after{content:" \25B2"}th[aria-sort=descending]::after{content:" \25BC"}
tr.best td{font-weight:600;color:var(--best)}tr.picked td{background:var(--card);
outline:2px solid var(--accent);outline-offset:-2px}td.failed{color:var(--best)}
label{color:var(--muted)}select{font:inherit;padding:2px 6px;margin-left:6px}
details{margin:10px 0}summary{cursor:pointer;color:var(--accent)}
)";

/// Tables sort by a click on their heads, unknown values last; one metric's charts are shown; a
/// click on a setting's point shows its row.
inline constexpr const char* kPageScript = R"(
document.querySelectorAll('thead th').forEach(function(th){
  th.tabIndex=0;
  function sort(){
    var table=th.closest('table'),body=table.tBodies[0],column=th.cellIndex;
    var up=th.getAttribute('aria-sort')!=='ascending';
    table.querySelectorAll('th').forEach(function(o){o.removeAttribute('aria-sort')});
    th.setAttribute('aria-sort',up?'ascending':'descending');
    function key(row){
      var cell=row.cells[column],number=cell.dataset.v;
      return number===undefined?cell.textContent:number===''?null:Number(number);
    }
    Array.from(body.rows).map(function(row){return [key(row),row]}).sort(function(a,b){
      if(a[0]===null||b[0]===null)return (a[0]===null)-(b[0]===null);
      var order=a[0]<b[0]?-1:a[0]>b[0]?1:0;
      return up?order:-order;
    }).forEach(function(pair){body.appendChild(pair[1])});
  }
  th.addEventListener('click',sort);
  th.addEventListener('keydown',function(e){if(e.key==='Enter')sort()});
});
var choice=document.getElementById('metric');
function show(){
  document.querySelectorAll('[data-metric]').forEach(function(block){
    block.hidden=choice.value!=='*'&&block.dataset.metric!==choice.value;
  });
}
if(choice){choice.addEventListener('change',show);show()}
document.querySelectorAll('[data-setting]').forEach(function(point){
  point.addEventListener('click',function(){
    document.querySelectorAll('tr.picked').forEach(function(r){r.classList.remove('picked')});
    var row=document.getElementById('setting-'+point.dataset.setting);
    row.classList.add('picked');
    row.scrollIntoView({behavior:'smooth',block:'center'});
  });
});
)";

}  // namespace vdamf
