#include "widgets/panels/robot_list.h"

#include <algorithm>
#include <utility>

#include <QPainter>
#include <QScopedValueRollback>
#include <QStyledItemDelegate>

#include "widgets/models/figures.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/sheet.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr int chip_px = 24;
constexpr int bar_height_px = 6;
constexpr int percent_width_px = 44;
constexpr int short_battery_px = 100; ///< beside the state
constexpr int most_lines = 3;

void paintNumberChip(QPainter* painter, const QRect& chip, const RobotRow& robot) {
    const QColor color = robotColor(robot.number);
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(color, 2.0));
    painter->setBrush(robot.stale ? QBrush(Qt::NoBrush) : QBrush(color));
    painter->drawRoundedRect(QRectF(chip).adjusted(1, 1, -1, -1), 4, 4);
    painter->setPen(robot.stale ? tokens().stale : inkOn(color));
    painter->setFont(themeFont(FontRole::Body, QFont::DemiBold));
    painter->drawText(chip, Qt::AlignCenter, QString::number(robot.number));
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
    paintElided(*painter, line, robot.name);
    line.setLeft(line.left() + painter->fontMetrics().horizontalAdvance(robot.name) + gap::small);
    painter->setFont(themeFont());
    painter->setPen(robot.stale ? t.stale : t.text_muted);
    if (line.width() > chip_px)
        paintElided(*painter, line, robot.class_name);
}

void paintState(QPainter* painter, QRect line, const RobotRow& robot) {
    const Tokens& t = tokens();
    QFont font = themeFont();
    painter->setPen(robot.stale ? t.stale : t.text);
    if (robot.stale) {
        const QString words = RobotList::tr("no news");
        painter->setFont(font);
        paintElided(*painter, line, words);
        line.setLeft(line.left() + painter->fontMetrics().horizontalAdvance(words) + gap::small);
        font.setStrikeOut(true);
    }
    painter->setFont(font);
    if (line.width() > chip_px)
        paintElided(*painter, line, robot.state);
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
    const QColor level = *robot.battery_pct < battery_danger_pct    ? t.danger
                         : *robot.battery_pct < battery_caution_pct ? t.caution
                                                                    : t.ok;
    bar.setWidth(bar.width() * share);
    painter->setBrush(robot.stale ? t.stale : level);
    painter->drawRoundedRect(bar, bar_height_px / 2.0, bar_height_px / 2.0);
    painter->setFont(themeFont(FontRole::Small));
    painter->setPen(robot.stale ? t.stale : t.text_muted);
    painter->drawText(line, Qt::AlignRight | Qt::AlignVCenter, figure(*robot.battery_pct, 0) + QStringLiteral(" %"));
}

int rowHeight_px(int lines) {
    return std::max(chip_px, lines * QFontMetrics(themeFont()).height()) + 2 * (lines == 1 ? 2 : gap::tiny);
}

/// Paints the battery's charge in words at the right of the line; returns the rest of the line.
QRect paintPercent(QPainter* painter, QRect line, const RobotRow& robot) {
    if (robot.battery_pct)
        paintBattery(painter, QRect(line.right() - percent_width_px, line.top(), percent_width_px, line.height()),
                     robot);
    line.setRight(line.right() - percent_width_px - gap::small);
    return line;
}

/// Name and state in one line; the class, which the tooltip has, and a behavior that drives are left out.
void paintOneLine(QPainter* painter, QRect line, const RobotRow& robot) {
    line = paintPercent(painter, line, robot);
    if (robot.driver.driver == Driver::Person)
        line = paintDriver(painter, line, robot);
    painter->setFont(themeFont(FontRole::Body, QFont::DemiBold));
    painter->setPen(robot.stale ? tokens().stale : tokens().text);
    paintElided(*painter, line, robot.name);
    line.setLeft(line.left() + painter->fontMetrics().horizontalAdvance(robot.name) + gap::small);
    if (line.width() > chip_px)
        paintState(painter, line, robot);
}

} // namespace

/// Paints a robot's row: color chip with its number, name, class, state in words, battery bar. Stale rows are gray with
/// the state struck through and the words "no news". Where there is little room, a row has fewer lines.
class RobotDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    int lines = most_lines; ///< 1 to 3

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const RobotRow& robot = static_cast<const RobotListModel*>(index.model())->row(index.row());
        const bool selected = option.state & QStyle::State_Selected;
        painter->save();
        if (!selected && option.state & QStyle::State_MouseOver)
            painter->fillRect(option.rect, faded(tokens().raised, 0.55));
        paintRowGround(*painter, option);
        if (selected)
            painter->fillRect(QRect(option.rect.topLeft(), QSize(3, option.rect.height())), tokens().accent);
        const int above_px = lines == 1 ? 2 : gap::tiny;
        const QRect inner = option.rect.adjusted(gap::small, above_px, -gap::small, -above_px);
        paintNumberChip(painter, QRect(inner.topLeft(), QSize(chip_px, chip_px)), robot);
        paintLines(painter, inner.adjusted(chip_px + gap::small, 0, 0, 0), robot);
        painter->restore();
    }
    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
        return {200, rowHeight_px(lines)};
    }

private:
    void paintLines(QPainter* painter, QRect line, const RobotRow& robot) const {
        if (lines == 1)
            return paintOneLine(painter, line, robot);
        const int line_px = QFontMetrics(themeFont()).height();
        line.setHeight(line_px);
        paintTitle(painter, line, robot);
        line.translate(0, line_px);
        QRect battery = line.translated(0, line_px);
        if (lines == 2 && robot.battery_pct) {
            battery = line;
            battery.setLeft(line.right() - short_battery_px);
            line.setRight(battery.left() - gap::small);
        }
        paintState(painter, line, robot);
        paintBattery(painter, battery, robot);
    }
};

RobotList::RobotList(QWidget* parent) : QWidget(parent), delegate_(new RobotDelegate(view_)) {
    laidOut(new QVBoxLayout(this), {}, -1, {view_});
    setUpPaintedRows(view_, model_, delegate_, tr("Robots"));
    view_->setUniformItemSizes(true);
    view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    view_->setMouseTracking(true);
    view_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(addRowAction(view_, tr("Remove this robot"), QKeySequence::Delete), &QAction::triggered, this, [this] {
        for (const RobotId id : chosenRobots())
            emit removeRequested(id);
    });
    connect(view_, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) { popUpRowMenu(view_, at); });
    connect(view_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& current) {
        if (!quiet_ && current.isValid())
            emit robotSelected(model_->row(current.row()).id);
    });
    connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        markSelected();
        emit chosenChanged();
    });
    for (const auto change : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(model_, change, this, [this] {
            fitRows();
            emit wholeHeightChanged();
        });
    empty_state_ = new EmptyState(view_, tr("No robot yet"), tr("Double-click a start pose on the map to spawn one."));
}

void RobotList::updateRobot(const RobotRow& robot) {
    const QScopedValueRollback quiet(quiet_, true);
    const std::optional<RobotId> selected = selectedRobot();
    model_->updateRobot(robot);
    if (selected && selectedRobot() != selected)
        selectRobot(*selected);
    updateEmptyState();
}

void RobotList::removeRobot(RobotId id) {
    model_->removeRobot(id);
    markSelected();
    updateEmptyState();
}

void RobotList::selectRobot(RobotId id) {
    const QScopedValueRollback quiet(quiet_, true);
    const std::optional<int> at = model_->indexOf(id);
    const QModelIndex index = at ? model_->index(*at) : QModelIndex();
    if (index.isValid() && index == view_->currentIndex())
        return markSelected();
    view_->selectionModel()->setCurrentIndex(index, QItemSelectionModel::ClearAndSelect);
}

void RobotList::markSelected() {
    const QModelIndex current = view_->currentIndex();
    if (current.isValid() && !view_->selectionModel()->isSelected(current))
        view_->selectionModel()->select(current, QItemSelectionModel::Select);
}

std::vector<RobotId> RobotList::chosenRobots() const {
    std::vector<RobotId> chosen;
    for (int row = 0; row < model_->rowCount(); ++row)
        if (const QModelIndex index = model_->index(row);
            view_->selectionModel()->isSelected(index) || index == view_->currentIndex())
            chosen.push_back(model_->row(row).id);
    return chosen;
}

QStringList RobotList::chosenNames() const {
    QStringList names;
    for (const RobotId id : chosenRobots())
        names << model_->row(*model_->indexOf(id)).name;
    return names;
}

std::optional<RobotId> RobotList::selectedRobot() const {
    const QModelIndex current = view_->currentIndex();
    return current.isValid() ? std::optional(model_->row(current.row()).id) : std::nullopt;
}

int RobotList::wholeHeight_px(int lines) const {
    return model_->rowCount() * rowHeight_px(lines) + 2 * view_->frameWidth();
}

int RobotList::heightWithin_px(int most_px) const {
    for (int lines = most_lines; lines >= 1; --lines)
        if (wholeHeight_px(lines) <= most_px)
            return wholeHeight_px(lines);
    return most_px;
}

void RobotList::fitRows() {
    int lines = most_lines;
    while (lines > 1 && wholeHeight_px(lines) > height())
        --lines;
    if (std::exchange(delegate_->lines, lines) != lines)
        view_->doItemsLayout();
}

void RobotList::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitRows();
}

void RobotList::updateEmptyState() {
    empty_state_->setVisible(model_->rowCount() == 0);
}

} // namespace usar::widgets
