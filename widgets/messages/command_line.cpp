#include "widgets/messages/command_line.h"

#include <QPainter>
#include <QPainterPath>

#include "core/base/text.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

/// Paints a wave two pixels high, as in other editors.
void paintWave(QPainter& painter, double from_px, double to_px, double base_px) {
    constexpr double step_px = 2.0;
    QPainterPath wave(QPointF(from_px, base_px));
    bool up = true;
    for (double x = from_px + step_px; x <= std::max(to_px, from_px + 3 * step_px); x += step_px, up = !up)
        wave.lineTo(x, base_px - (up ? 2.0 : 0.0));
    painter.drawPath(wave);
}

} // namespace

CommandLine::CommandLine(QWidget* parent) : QLineEdit(parent) {
    setFont(codeFont());
    setMinimumHeight(minimum_target);
    setClearButtonEnabled(true);
}

void CommandLine::setDiagnostics(const Diagnostics& diagnostics) {
    if (diagnostics == diagnostics_)
        return;
    diagnostics_ = diagnostics;
    update();
}

std::size_t CommandLine::wordEnd(std::size_t offset) const {
    const std::string bytes = text().toStdString();
    std::size_t end = std::min(offset, bytes.size());
    while (end < bytes.size() && !isSpace(bytes[end]) && bytes[end] != '}' && (bytes[end] != '{' || end == offset))
        ++end;
    return end;
}

void CommandLine::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    if (diagnostics_.empty())
        return;
    const QByteArray bytes = text().toUtf8();
    const QFontMetricsF metrics(font());
    const auto advance = [&](std::size_t byte) {
        return metrics.horizontalAdvance(QString::fromUtf8(bytes.left(static_cast<qsizetype>(byte))));
    };
    const double zero_px = cursorRect().center().x() - advance(cursorByte());
    const double base_px = cursorRect().bottom() + 1.0;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(rect().adjusted(3, 0, -3, 0));
    for (const Diagnostic& diagnostic : diagnostics_) {
        painter.setPen(QPen(diagnostic.severity == Severity::Error ? tokens().danger : tokens().caution, 1.2));
        const std::size_t end = wordEnd(diagnostic.offset);
        paintWave(painter, zero_px + advance(diagnostic.offset), zero_px + advance(end), base_px);
    }
}

} // namespace usar::widgets
