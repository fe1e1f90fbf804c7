#include "widgets/panels/robot_delegate.h"

#include <algorithm>

#include <QPainter>

#include "widgets/models/figures.h"
#include "widgets/models/robot_list_model.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr int chip_px = 24;
constexpr int bar_height_px = 6;
constexpr int percent_width_px = 44;

void paintGround(QPainter* painter, const QStyleOptionViewItem& option) {
    const Tokens& t = tokens();
    if (option.state & QStyle::State_Selected) {
        painter->fillRect(option.rect, t.raised);
        painter->fillRect(QRect(option.rect.topLeft(), QSize(3, option.rect.height())), t.accent);
    } else if (option.state & QStyle::State_MouseOver) {
        QColor faint = t.raised;
        faint.setAlpha(140);
        painter->fillRect(option.rect, faint);
    }
    if (option.state & QStyle::State_HasFocus) {
        painter->setPen(t.accent);
        painter->drawRect(option.rect.adjusted(0, 0, -1, -1));
    }
}

void paintChip(QPainter* painter, const QRect& chip, const RobotRow& robot) {
    const QColor color = robotColor(robot.number);
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(color, 2.0));
    painter->setBrush(robot.stale ? QBrush(Qt::NoBrush) : QBrush(color));
    painter->drawRoundedRect(QRectF(chip).adjusted(1, 1, -1, -1), 4, 4);
    painter->setPen(robot.stale ? tokens().stale : inkOn(color));
    painter->setFont(themeFont(FontRole::Body, QFont::DemiBold));
    painter->drawText(chip, Qt::AlignCenter, QString::number(robot.number));
}

void paintElided(QPainter* painter, const QRect& rect, const QString& text) {
    painter->drawText(rect, Qt::AlignLeft | Qt::AlignVCenter,
                      painter->fontMetrics().elidedText(text, Qt::ElideRight, rect.width()));
}

/// Paints who drives at the right of the title; returns the rest of the line.
QRect paintDriver(QPainter* painter, QRect line, const RobotRow& robot) {
    if (robot.driver.robot.isEmpty() || robot.stale)
        return line;
    const bool person = robot.driver.driver == Driver::Person;
    painter->setFont(themeFont(FontRole::Small, person ? QFont::DemiBold : QFont::Normal));
    painter->setPen(person ? tokens().accent : tokens().text_muted);
    const QString text = painter->fontMetrics().elidedText(controlText(robot.driver), Qt::ElideRight, line.width() / 2);
    painter->drawText(line, Qt::AlignRight | Qt::AlignVCenter, text);
    line.setRight(line.right() - painter->fontMetrics().horizontalAdvance(text) - gap::small);
    return line;
}

void paintTitle(QPainter* painter, QRect line, const RobotRow& robot) {
    const Tokens& t = tokens();
    line = paintDriver(painter, line, robot);
    painter->setFont(themeFont(FontRole::Body, QFont::DemiBold));
    painter->setPen(robot.stale ? t.stale : t.text);
    paintElided(painter, line, robot.name);
    line.setLeft(line.left() + painter->fontMetrics().horizontalAdvance(robot.name) + gap::small);
    painter->setFont(themeFont());
    painter->setPen(robot.stale ? t.stale : t.text_muted);
    if (line.width() > chip_px)
        paintElided(painter, line, robot.class_name);
}

void paintState(QPainter* painter, QRect line, const RobotRow& robot) {
    const Tokens& t = tokens();
    QFont font = themeFont();
    painter->setPen(robot.stale ? t.stale : t.text);
    if (robot.stale) {
        const QString words = RobotDelegate::tr("no news");
        painter->setFont(font);
        paintElided(painter, line, words);
        line.setLeft(line.left() + painter->fontMetrics().horizontalAdvance(words) + gap::small);
        font.setStrikeOut(true);
    }
    painter->setFont(font);
    if (line.width() > chip_px)
        paintElided(painter, line, robot.state);
}

void paintBattery(QPainter* painter, const QRect& line, const RobotRow& robot) {
    if (!robot.battery_pct)
        return;
    const Tokens& t = tokens();
    const double share = std::clamp(*robot.battery_pct / 100.0, 0.0, 1.0);
    QRectF bar(line.left(), line.center().y() - bar_height_px / 2.0 + 0.5, line.width() - percent_width_px,
               bar_height_px);
    painter->setPen(Qt::NoPen);
    painter->setBrush(t.line);
    painter->drawRoundedRect(bar, bar_height_px / 2.0, bar_height_px / 2.0);
    const QColor level = share < 0.15 ? t.danger : share < 0.3 ? t.caution : t.ok;
    bar.setWidth(bar.width() * share);
    painter->setBrush(robot.stale ? t.stale : level);
    painter->drawRoundedRect(bar, bar_height_px / 2.0, bar_height_px / 2.0);
    painter->setFont(themeFont(FontRole::Small));
    painter->setPen(robot.stale ? t.stale : t.text_muted);
    painter->drawText(line, Qt::AlignRight | Qt::AlignVCenter, figure(*robot.battery_pct, 0) + QStringLiteral(" %"));
}

} // namespace

void RobotDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const RobotRow& robot = static_cast<const RobotListModel*>(index.model())->row(index.row());
    painter->save();
    paintGround(painter, option);
    const QRect inner = option.rect.adjusted(gap::small, gap::tiny, -gap::small, -gap::tiny);
    paintChip(painter, QRect(inner.topLeft(), QSize(chip_px, chip_px)), robot);
    const int line_px = QFontMetrics(themeFont()).height();
    QRect line = inner.adjusted(chip_px + gap::small, 0, 0, 0);
    line.setHeight(line_px);
    paintTitle(painter, line, robot);
    line.translate(0, line_px);
    paintState(painter, line, robot);
    line.translate(0, line_px);
    paintBattery(painter, line, robot);
    painter->restore();
}

QSize RobotDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const {
    return {200, 3 * QFontMetrics(themeFont()).height() + 2 * gap::tiny};
}

} // namespace usar::widgets
