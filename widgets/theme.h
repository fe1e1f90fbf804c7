// Colors, spacing and fonts of the whole window: the only file that knows them.
#pragma once

#include <array>

#include <QColor>
#include <QFont>

#include "core/agent/published.h"
#include "core/protocol/commands/trace.h"

namespace usar::widgets {

enum class Theme { Dark, Light };

/// What every view paints with. Text tokens (text, text_muted, accent, ok, caution, danger, stale) have a contrast of
/// at least 4.5:1 on background, surface and raised; `on_fill` has it on accent and on `stop`.
struct Tokens {
    QColor background; ///< behind everything; the map's outer space
    QColor surface;    ///< panels, lists
    QColor ground;     ///< unknown ground of the world: bluish, so that no shade of gray is taken for it
    QColor raised;     ///< buttons, chips, headers, popovers
    QColor line;       ///< hairlines, grid, frames
    QColor text;
    QColor text_muted; ///< units, captions
    QColor accent;     ///< selection, focus, links, goal
    QColor ok;
    QColor caution;
    QColor danger;
    QColor stale;   ///< values that nobody vouches for any more
    QColor stop;    ///< fill of the stop button
    QColor on_fill; ///< text on accent and stop fills
    QColor laser;   ///< hits and rays of the scanner
};

const Tokens& tokens(Theme theme);
/// Of the theme applied last; dark before the first call. GUI thread only.
const Tokens& tokens();
/// The one applied last.
Theme currentTheme();

/// Fusion, palette, fonts and the style sheet of the application; every widget gets a PaletteChange. GUI thread.
void applyTheme(Theme theme);

/// Colors of robots 1 to 9 (Okabe and Ito, distinguishable under the common color deficiencies); other numbers wrap.
QColor robotColor(int number);
/// Black or white, whichever reads better on `fill`.
QColor inkOn(const QColor& fill);

/// Colors of the thesis's marks (figure 4.4), the same in both themes and in exported pictures.
QColor markColor(agent::MarkKind kind);
/// The protocol's colors of TRACE, the same in both themes; on the map each mark has a dark rim.
QColor traceColor(protocol::TraceColor color);
/// "Red": the protocol's word.
QString traceColorName(protocol::TraceColor color);
inline constexpr std::array all_trace_colors = {
    protocol::TraceColor::Red,   protocol::TraceColor::Yellow, protocol::TraceColor::Green, protocol::TraceColor::Cyan,
    protocol::TraceColor::White, protocol::TraceColor::Blue,   protocol::TraceColor::Purple};
/// What a line of traffic is about. `Other`: a type that is none of these.
enum class LineFamily { State, Range, Pose, Sensor, Answer, Drive, Command, Other };
inline constexpr std::array all_line_families = {LineFamily::State,   LineFamily::Range,  LineFamily::Pose,
                                                 LineFamily::Sensor,  LineFamily::Answer, LineFamily::Drive,
                                                 LineFamily::Command, LineFamily::Other};
/// Ink of its type's word; reads like the text tokens. One's own words are blue.
QColor lineColor(LineFamily family, Theme theme);

/// "Low risk": the word beside the color, for legends and tooltips.
QString markName(agent::MarkKind kind);
inline constexpr std::array all_mark_kinds = {
    agent::MarkKind::Path,     agent::MarkKind::Diversion, agent::MarkKind::LowRisk,    agent::MarkKind::HighRisk,
    agent::MarkKind::Recharge, agent::MarkKind::Landing,   agent::MarkKind::GoalGivenUp};

/// WCAG 2 contrast ratio of two opaque colors, 1..21.
double contrast(const QColor& a, const QColor& b);

/// The 8 px grid: the only gaps there are, in device-independent pixels.
namespace gap {
inline constexpr int tiny = 4;
inline constexpr int small = 8;
inline constexpr int medium = 16;
inline constexpr int large = 24;
} // namespace gap
inline constexpr int minimum_target = 24; ///< smallest thing that can be clicked

/// One family with figures of equal width, three sizes. `Number` is for figures that change, `Big` for the instruments.
enum class FontRole { Small, Body, Big };
QFont themeFont(FontRole role = FontRole::Body, QFont::Weight weight = QFont::Normal);
/// Fixed pitch, for protocol lines.
QFont codeFont();

} // namespace usar::widgets
