// SPDX-License-Identifier: GPL-3.0-or-later
#include "stylesheet.hpp"

#include <string>

namespace stickslip::plot_detail {

std::string_view stylesheet() {
  return R"(.stickslip text { font: 13px Helvetica, Arial, "Liberation Sans", "DejaVu Sans", sans-serif; fill: #1a1a1a }
.stickslip .title { font-size: 18px; font-weight: bold }
.stickslip .large { font-size: 15px } .stickslip .small { font-size: 11px } .stickslip .tiny { font-size: 9px }
.stickslip .muted { fill: #555555 }
.stickslip .state { font-family: "DejaVu Sans Mono", Menlo, Consolas, monospace; letter-spacing: .12em }
.stickslip .middle { text-anchor: middle }
.stickslip .end { text-anchor: end }
.stickslip .halo { paint-order: stroke; stroke: #ffffff; stroke-width: 3px; stroke-linejoin: round }
.stickslip path, .stickslip line, .stickslip circle { stroke-linejoin: round; stroke-linecap: round; fill: none }
.stickslip .paper { fill: #ffffff }
.stickslip .body { fill: #f1efe9; stroke: #b4aea1 }
.stickslip .ghost { stroke: #007a5a; stroke-width: 1.2; stroke-dasharray: 5 4 }
.stickslip .virtual-ghost { stroke: #9c3f76; stroke-width: 1.2; stroke-dasharray: 2 3 }
.stickslip .virtual-pivot { stroke: #9c3f76; stroke-width: 1.4 }
.stickslip .leader { stroke: #777777; stroke-width: .8 }
.stickslip .cone { fill: #e69f00; fill-opacity: .22; stroke: #b37b00; stroke-width: .8 }
.stickslip .axis { stroke: #777777; stroke-width: .9; stroke-dasharray: 7 2.5 1.5 2.5 }
.stickslip .normal { stroke: #777777; fill: #777777; stroke-width: 1 }
.stickslip .finger, .stickslip .frame { stroke: #555555; stroke-width: 1.2 }
.stickslip .preload { stroke: #1a1a1a; stroke-width: 2.6; stroke-linecap: butt }
.stickslip .force { stroke: #0072b2; fill: #0072b2; stroke-width: 2.8 }
.stickslip .load { stroke: #c24a00; fill: #ffffff; stroke-width: 2.2 }
.stickslip .torque { stroke: #c24a00; stroke-width: 2.2 }
.stickslip .motion { stroke: #007a5a; fill: #007a5a; stroke-width: 1.3 }
.stickslip .virtual { stroke: #9c3f76; fill: #9c3f76; stroke-width: 1.3 }
.stickslip .full { fill: #1a1a1a; stroke: #1a1a1a; stroke-width: 1.4 }
.stickslip .hollow { fill: #ffffff; stroke: #1a1a1a; stroke-width: 1.4 }
.stickslip .rule { stroke: #1a1a1a; stroke-width: 1.4; stroke-linecap: butt }
.stickslip .rim { stroke: #1a1a1a; stroke-width: 1.2 }
.stickslip .ring { stroke: #1a1a1a; stroke-width: .8; stroke-opacity: .45; stroke-dasharray: 1.5 4 }
.stickslip .edge { stroke: #1a1a1a; stroke-width: 1.5 }
.stickslip .thin .edge { stroke-width: .7 }
.stickslip .vertex { fill: #1a1a1a }
.stickslip .border { stroke: #1a1a1a; fill: #1a1a1a; stroke-width: 1.8 }
.stickslip .grid-line { stroke: #1a1a1a; stroke-width: .6; stroke-opacity: .16 }
.stickslip .axis-line { stroke: #1a1a1a; stroke-width: 1; stroke-opacity: .55 }
.stickslip .hue0 { fill: #77aadd } .stickslip .hue1 { fill: #eedd88 }
.stickslip .hue2 { fill: #ffaabb } .stickslip .hue3 { fill: #44bb99 }
.stickslip .hue4 { fill: #dddddd } .stickslip .hue5 { fill: #ee8866 }
.stickslip .hue6 { fill: #99ddff } .stickslip .hue7 { fill: #bbcc33 }
.stickslip .hatching { stroke: #1a1a1a; stroke-width: .9; stroke-opacity: .55; stroke-linecap: butt }
.stickslip .hatch0 { fill: url(#stickslip-hatch0) } .stickslip .hatch1 { fill: url(#stickslip-hatch1) }
.stickslip .hatch2 { fill: url(#stickslip-hatch2) } .stickslip .hatch3 { fill: url(#stickslip-hatch3) }
.stickslip .hatch4 { fill: url(#stickslip-hatch4) } .stickslip .hatch5 { fill: url(#stickslip-hatch5) }
.stickslip .hatch6 { fill: url(#stickslip-hatch6) } .stickslip .hatch7 { fill: url(#stickslip-hatch7) }
.stickslip .shade0 { fill: #f7fbff } .stickslip .shade1 { fill: #e3eef9 } .stickslip .shade2 { fill: #cfe1f2 }
.stickslip .shade3 { fill: #b5d4e9 } .stickslip .shade4 { fill: #93c3df } .stickslip .shade5 { fill: #6daed5 }
.stickslip .shade6 { fill: #4b97c9 } .stickslip .shade7 { fill: #2f7ebc } .stickslip .shade8 { fill: #1864aa }
@media screen and (prefers-color-scheme: dark) {
.stickslip text { fill: #e8e8e8 }
.stickslip .muted { fill: #a8adb5 }
.stickslip .halo { stroke: #15181d }
.stickslip .paper { fill: #15181d }
.stickslip .body { fill: #262b33; stroke: #596270 }
.stickslip .ghost { stroke: #3fd0a4 }
.stickslip .virtual-ghost, .stickslip .virtual-pivot { stroke: #e79bc8 }
.stickslip .cone { fill: #f0b840; fill-opacity: .18; stroke: #b98d2c }
.stickslip .axis, .stickslip .normal, .stickslip .leader { stroke: #9299a3 }
.stickslip .normal { fill: #9299a3 }
.stickslip .finger, .stickslip .frame { stroke: #a8adb5 }
.stickslip .preload, .stickslip .rule, .stickslip .rim, .stickslip .ring { stroke: #e8e8e8 }
.stickslip .force { stroke: #5fb8f0; fill: #5fb8f0 }
.stickslip .load, .stickslip .torque { stroke: #ff8c42 }
.stickslip .load { fill: #15181d }
.stickslip .motion { stroke: #3fd0a4; fill: #3fd0a4 }
.stickslip .virtual { stroke: #e79bc8; fill: #e79bc8 }
.stickslip .full { fill: #e8e8e8; stroke: #e8e8e8 }
.stickslip .hollow { fill: #15181d; stroke: #e8e8e8 }
.stickslip .edge { stroke: #e8e8e8 }
.stickslip .vertex { fill: #e8e8e8 }
.stickslip .border { stroke: #e8e8e8; fill: #e8e8e8 }
.stickslip .grid-line, .stickslip .axis-line { stroke: #e8e8e8 }
.stickslip .hue0 { fill: #2c5a88 } .stickslip .hue1 { fill: #756515 }
.stickslip .hue2 { fill: #8a3f52 } .stickslip .hue3 { fill: #1b6b54 }
.stickslip .hue4 { fill: #55595f } .stickslip .hue5 { fill: #8f4426 }
.stickslip .hue6 { fill: #2a7391 } .stickslip .hue7 { fill: #5b6612 }
.stickslip .hatching { stroke: #e8e8e8 }
.stickslip .shade0 { fill: #16202c } .stickslip .shade1 { fill: #172b40 } .stickslip .shade2 { fill: #183653 }
.stickslip .shade3 { fill: #194267 } .stickslip .shade4 { fill: #1b4f7c } .stickslip .shade5 { fill: #1f5d92 }
.stickslip .shade6 { fill: #266da8 } .stickslip .shade7 { fill: #317ebf } .stickslip .shade8 { fill: #4190d4 }
}
)";
}

void define_hatching(Svg& svg) {
  svg.open("defs");
  for (int i = 0; i < kHues; ++i) {
    const std::string number = std::to_string(i);
    svg.open("pattern", {{"id", "stickslip-hatch" + number},
                         {"width", "7"},
                         {"height", "7"},
                         {"patternUnits", "userSpaceOnUse"},
                         {"patternTransform", "rotate(45)"}});
    svg.element("rect", {{"class", "hue" + number}, {"width", "7"}, {"height", "7"}});
    svg.line({3.5, 0}, {3.5, 7}, "hatching");
    svg.close();
  }
  svg.close();
}

}  // namespace stickslip::plot_detail
