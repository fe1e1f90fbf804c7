#include "widgets/style/style_sheet.h"

namespace usar::widgets {

namespace {

constexpr const char* rules = R"(
QToolTip { color: %text; background: %raised; border: 1px solid %line; padding: 4px; }
QMainWindow::separator { background: %background; width: 4px; height: 4px; }
QMainWindow::separator:hover { background: %accent; }
QDockWidget { titlebar-close-icon: none; titlebar-normal-icon: none; }
QDockWidget::title { background: %background; color: %text_muted; padding: 4px 8px; text-align: left; }
QHeaderView::section { background: %surface; color: %text_muted; border: none; border-bottom: 1px solid %line;
    padding: 4px 3px; }
QStatusBar::item { border: none; }
QLabel[role="muted"] { color: %text_muted; }
QLabel[role="title"] { color: %text; font-weight: 600; }
QLabel[role="ok"] { color: %ok; }
QLabel[role="caution"] { color: %caution; }
QLabel[role="danger"] { color: %danger; }
QFrame[role="card"] { background: %raised; border: 1px solid %line; border-radius: 8px; }
QFrame[role="strip"] { background: %surface; border: none; border-bottom: 1px solid %line; }
QPushButton[role="primary"], QPushButton[role="stop"] { color: %on_fill; border: 1px solid transparent;
    border-radius: 4px; padding: 4px 16px; min-height: 22px; font-weight: 600; }
QPushButton[role="primary"] { background: %primary; }
QPushButton[role="primary"]:hover { background: %primary_hover; }
QPushButton[role="stop"] { background: %stop; }
QPushButton[role="stop"]:hover { background: %stop_hover; }
QPushButton[role="primary"]:focus, QPushButton[role="stop"]:focus { border: 2px solid %text; padding: 3px 15px; }
QPushButton[role="primary"]:disabled, QPushButton[role="stop"]:disabled { background: %raised; color: %stale;
    border: 1px solid %line; }
)";

} // namespace

QString styleSheet(const Tokens& t) {
    QString sheet = QString::fromLatin1(rules);
    const QColor primary = contrast(t.on_fill, t.accent) >= 4.5 ? t.accent : QColor(0x1f6fc0);
    // Longer names come first, because %text would match the start of %text_muted.
    const std::pair<const char*, QColor> words[] = {
        {"%text_muted", t.text_muted},
        {"%primary_hover", primary.darker(115)},
        {"%stop_hover", t.stop.darker(115)},
        {"%background", t.background},
        {"%surface", t.surface},
        {"%raised", t.raised},
        {"%line", t.line},
        {"%text", t.text},
        {"%accent", t.accent},
        {"%on_fill", t.on_fill},
        {"%ok", t.ok},
        {"%caution", t.caution},
        {"%danger", t.danger},
        {"%stale", t.stale},
        {"%primary", primary},
        {"%stop", t.stop},
    };
    for (const auto& [word, color] : words)
        sheet.replace(QLatin1String(word), color.name());
    return sheet;
}

} // namespace usar::widgets
