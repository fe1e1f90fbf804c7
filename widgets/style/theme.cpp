#include "widgets/style/theme.h"

#include <array>
#include <cmath>
#include <utility>

#include <QApplication>
#include <QFontDatabase>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>

#include "core/agent/published.h"

namespace usar::widgets {

namespace {

const Tokens dark_tokens = {
    .background = QColor(0x12161b),
    .surface = QColor(0x1a2027),
    .ground = QColor(0x17273a),
    .raised = QColor(0x252d37),
    .line = QColor(0x3b4653),
    .text = QColor(0xe8ecf1),
    .text_muted = QColor(0xa3afbd),
    .accent = QColor(0x5cb3ff),
    .ok = QColor(0x5fd08c),
    .caution = QColor(0xf5b83d),
    .danger = QColor(0xff8078),
    .stale = QColor(0x97a2af),
    .stop = QColor(0xd6302b),
    .on_fill = QColor(0xffffff),
    .laser = QColor(0xff5c8a),
};

const Tokens light_tokens = {
    .background = QColor(0xe9edf1),
    .surface = QColor(0xffffff),
    .ground = QColor(0xd3e2f2),
    .raised = QColor(0xf2f5f8),
    .line = QColor(0xbcc5cf),
    .text = QColor(0x161c23),
    .text_muted = QColor(0x515c69),
    .accent = QColor(0x0a5fb4),
    .ok = QColor(0x13703a),
    .caution = QColor(0x855300),
    .danger = QColor(0xb81f1f),
    .stale = QColor(0x606b77),
    .stop = QColor(0xc62828),
    .on_fill = QColor(0xffffff),
    .laser = QColor(0xc2185b),
};

Theme current_theme = Theme::Dark;

QPalette paletteOf(const Tokens& t) {
    QPalette p;
    p.setColor(QPalette::Window, t.background);
    p.setColor(QPalette::WindowText, t.text);
    p.setColor(QPalette::Base, t.surface);
    p.setColor(QPalette::AlternateBase, t.raised);
    p.setColor(QPalette::ToolTipBase, t.raised);
    p.setColor(QPalette::ToolTipText, t.text);
    p.setColor(QPalette::Text, t.text);
    p.setColor(QPalette::Button, t.raised);
    p.setColor(QPalette::ButtonText, t.text);
    p.setColor(QPalette::BrightText, t.danger);
    p.setColor(QPalette::Link, t.accent);
    p.setColor(QPalette::Highlight, t.accent);
    p.setColor(QPalette::HighlightedText, inkOn(t.accent));
    p.setColor(QPalette::PlaceholderText, t.text_muted);
    p.setColor(QPalette::Light, t.raised.lighter(130));
    p.setColor(QPalette::Midlight, t.raised.lighter(115));
    p.setColor(QPalette::Mid, t.line);
    p.setColor(QPalette::Dark, t.line.darker(120));
    p.setColor(QPalette::Shadow, t.background.darker(180));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText})
        p.setColor(QPalette::Disabled, role, t.stale);
    p.setColor(QPalette::Disabled, QPalette::Highlight, t.line);
    return p;
}

/// Returns the first installed family with digits of equal width; DejaVu is part of every desktop that we support.
QString family() {
    static const QString found = [] {
        const QStringList installed = QFontDatabase::families();
        for (const char* name : {"Noto Sans", "DejaVu Sans", "Liberation Sans", "Arimo"})
            if (installed.contains(QLatin1String(name)))
                return QString::fromLatin1(name);
        return QFontDatabase::systemFont(QFontDatabase::GeneralFont).family();
    }();
    return found;
}

double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& c) {
    return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

void outline(QPainter& painter, const QRect& rect, const QColor& ink) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(ink, 1.0));
    painter.drawRoundedRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5), 2.0, 2.0);
    painter.restore();
}

QColor checkBoxInk(QStyle::State state) {
    if (!(state & QStyle::State_Enabled))
        return tokens().line;
    return state & QStyle::State_HasFocus ? tokens().accent : tokens().text_muted;
}

/// In the light theme Fusion's own hairline is dark enough, and the focused widget has a ring.
bool needsHairline(const QStyleOption& option) {
    return currentTheme() == Theme::Dark && !(option.state & QStyle::State_HasFocus);
}

/// Fusion with visible outlines: on dark themes its own are darker than the background. Gives check boxes an outline
/// with a contrast of at least 3:1, and fields and spin boxes of the dark theme a hairline. Reads the tokens while
/// painting, so it need not be told about a new theme.
class OutlineStyle : public QProxyStyle {
public:
    OutlineStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        if (element == PE_IndicatorCheckBox)
            outline(*painter, option->rect, checkBoxInk(option->state));
        else if (element == PE_FrameLineEdit && needsHairline(*option))
            outline(*painter, option->rect, tokens().line);
    }
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override {
        QProxyStyle::drawComplexControl(control, option, painter, widget);
        if (control == CC_SpinBox && needsHairline(*option))
            outline(*painter, option->rect, tokens().line);
    }
    /// Buttons of dialogs have words; Qt's pictures for them are of another family than ours.
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* more) const override {
        return hint == SH_DialogButtonBox_ButtonsHaveIcons ? 0 : QProxyStyle::styleHint(hint, option, widget, more);
    }
};

/// What Fusion and a palette cannot express: tooltips, dock titles, headers, and the roles that widgets have by the
/// dynamic property `role`: labels "muted", "title", "accent", "danger", "caution", "ok"; fields "caution", "danger";
/// buttons "primary", "stop"; frames "card", "strip".
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
QLabel[role="accent"] { color: %accent; }
QLabel[role="ok"] { color: %ok; }
QLabel[role="caution"] { color: %caution; }
QLabel[role="danger"] { color: %danger; }
QAbstractSpinBox[role="caution"] { color: %caution; }
QLineEdit[role="danger"] { color: %danger; }
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

} // namespace

const Tokens& tokens(Theme theme) {
    return theme == Theme::Dark ? dark_tokens : light_tokens;
}

const Tokens& tokens() {
    return tokens(current_theme);
}

Theme currentTheme() {
    return current_theme;
}

Theme desktopTheme() {
    static const Theme at_start =
        QGuiApplication::palette().color(QPalette::Window).lightness() < 128 ? Theme::Dark : Theme::Light;
    return at_start;
}

void applyTheme(Theme theme) {
    desktopTheme(); // It is read before the palette becomes ours.
    current_theme = theme;
    // A style sheet wraps the style, so the style's name is no indication: a property says whether the style has been
    // set.
    if (!qApp->property("usar_style_set").toBool()) {
        QApplication::setStyle(new OutlineStyle);
        qApp->setProperty("usar_style_set", true);
    }
    QApplication::setFont(themeFont());
    QApplication::setPalette(paletteOf(tokens()));
    qApp->setStyleSheet(styleSheet(tokens()));
}

QColor robotColor(int number) {
    static const std::array<QColor, 9> colors = {QColor(0x56b4e9), QColor(0xe69f00), QColor(0x00b486),
                                                 QColor(0xf0e442), QColor(0xd55e00), QColor(0xcc79a7),
                                                 QColor(0x2f7fc4), QColor(0x9a9a9a), QColor(0xb8a1f0)};
    const int count = static_cast<int>(colors.size());
    return colors[static_cast<std::size_t>(((number - 1) % count + count) % count)];
}

QColor inkOn(const QColor& fill) {
    const QColor black(0x0b0e12);
    return contrast(black, fill) >= contrast(Qt::white, fill) ? black : QColor(Qt::white);
}

QColor riskColor(agent::Risk risk) {
    return risk == agent::Risk::None ? tokens().ok : risk == agent::Risk::Low ? tokens().caution : tokens().danger;
}

QColor traceColor(protocol::TraceColor color) {
    static const std::array<QColor, protocol::wire_words<protocol::TraceColor>.size()> colors = {
        QColor(0xf0443c), QColor(0xf5d90a), QColor(0x2fbf4f), QColor(0x25c9d8),
        QColor(0xf4f6f8), QColor(0x3d7eff), QColor(0xb25cff)};
    return colors[static_cast<std::size_t>(color)];
}

QColor markColor(agent::MarkKind kind) {
    return QColor(agent::styleOf(kind).rgb);
}

QString markName(agent::MarkKind kind) {
    return QString::fromUtf8(agent::styleOf(kind).name);
}

QColor lineColor(LineFamily family, Theme theme) {
    // Each row has the colors for the dark and the light theme.
    static constexpr QRgb inks[][2] = {{0x7fd6a4, 0x13703a}, {0xc9a6ff, 0x6b3fb5}, {0x5fd3d9, 0x00696e},
                                       {0xf0a37a, 0x9a4310}, {0xf59ac6, 0xa3246f}, {0, 0},
                                       {0xa9b9ff, 0x3d49b8}};
    if (family == LineFamily::Drive)
        return tokens(theme).accent;
    if (family == LineFamily::Other)
        return tokens(theme).text_muted;
    return inks[static_cast<std::size_t>(family)][theme == Theme::Dark ? 0 : 1];
}

QColor faded(QColor color, double alpha) {
    color.setAlphaF(static_cast<float>(alpha));
    return color;
}

double contrast(const QColor& a, const QColor& b) {
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

QFont themeFont(FontRole role, QFont::Weight weight) {
    QFont font(family());
    const double points = role == FontRole::Small ? 8.0 : role == FontRole::Body ? 9.5 : 15.0;
    font.setPointSizeF(points);
    font.setWeight(weight);
    return font;
}

QFont codeFont() {
    QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    if (QFontDatabase::families().contains(QStringLiteral("DejaVu Sans Mono")))
        font.setFamily(QStringLiteral("DejaVu Sans Mono"));
    font.setPointSizeF(9.0);
    return font;
}

} // namespace usar::widgets
