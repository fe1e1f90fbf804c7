// Colors, spacing and fonts of the whole program. Those of marks are core/agent/mark_style.h, because the results of a
// mission without a window show them, too.
#pragma once

#include <QColor>
#include <QFont>

#include "core/agent/mark_style.h"
#include "core/protocol/commands/trace.h"

namespace usar::agent {
enum class Risk;
}

namespace usar::widgets {

enum class Theme { Dark, Light };

/// Colors that every view paints with. Text tokens (text, text_muted, accent, ok, caution, danger, stale) have a
/// contrast of at least 4.5:1 on background, surface and raised; `on_fill` has it on accent and on `stop`.
struct Tokens {
    QColor background; ///< below everything else, and outside the map's world
    QColor surface;    ///< panels, lists
    QColor ground;     ///< unknown ground of the world; bluish, so that it cannot be confused with a shade of gray
    QColor raised;     ///< buttons, chips, headers, popovers
    QColor line;       ///< hairlines, grid, frames
    QColor text;
    QColor text_muted; ///< units, captions
    QColor accent;     ///< selection, focus, links, goal
    QColor ok;
    QColor caution;
    QColor danger;
    QColor stale;   ///< values that may be out of date
    QColor stop;    ///< fill of the stop button
    QColor on_fill; ///< text on accent and stop fills
    QColor laser;   ///< hits and rays of the scanner
};

const Tokens& tokens(Theme theme);
/// Tokens of the current theme; dark before the first applyTheme. GUI thread only.
const Tokens& tokens();
/// The theme applied last; dark before the first.
Theme currentTheme();

/// Dark or light, as the palette was at the start of the program, which is the desktop's. GUI thread.
Theme desktopTheme();

/// Sets Fusion, palette, fonts and style sheet of the application; every widget gets a PaletteChange. GUI thread.
void applyTheme(Theme theme);

/// Colors of robots 1 to 9 (Okabe and Ito, distinguishable with the common color vision deficiencies); other numbers
/// wrap around.
QColor robotColor(int number);
/// Black or white, whichever has more contrast on `fill`.
QColor inkOn(const QColor& fill);

/// Colors of the thesis's marks (figure 4.4); the same in both themes and in exported pictures.
QColor markColor(agent::MarkKind kind);
/// Colors of a sonar's risk, for its column and the zones on it; as readable as the text tokens. GUI thread only.
QColor riskColor(agent::Risk risk);
/// Colors of the protocol's TRACE; the same in both themes. On the map each mark has a dark rim.
QColor traceColor(protocol::TraceColor color);
/// Topic of a line of traffic. `Other`: none of these.
enum class LineFamily { State, Range, Pose, Sensor, Answer, Drive, Command, Other };
/// Text color for the type of a line; as readable as the text tokens. Our own commands are blue.
QColor lineColor(LineFamily family, Theme theme);

/// "Low risk": the name beside the color, for legends and tooltips.
QString markName(agent::MarkKind kind);
using agent::all_mark_kinds;

/// The color with an opacity of 0..1.
QColor faded(QColor color, double alpha);
/// WCAG 2 contrast ratio of two opaque colors, 1..21.
double contrast(const QColor& a, const QColor& b);

/// The 8 px grid: the only gaps in use, in device-independent pixels.
namespace gap {
inline constexpr int tiny = 4;
inline constexpr int small = 8;
inline constexpr int medium = 16;
inline constexpr int large = 24;
} // namespace gap
inline constexpr int minimum_target = 24; ///< smallest size of anything that can be clicked

/// One font family with digits of equal width, in three sizes. `Big` is for the figures of instruments.
enum class FontRole { Small, Body, Big };
/// The font of a role in the theme's family.
QFont themeFont(FontRole role = FontRole::Body, QFont::Weight weight = QFont::Normal);
/// Fixed-pitch font, for protocol lines.
QFont codeFont();

} // namespace usar::widgets
