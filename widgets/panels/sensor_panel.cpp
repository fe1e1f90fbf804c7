#include "widgets/panels/sensor_panel.h"

#include <algorithm>
#include <chrono>

#include <QHeaderView>

#include "core/protocol/silence.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

SensorPanel::SensorPanel(QWidget* parent)
    : QWidget(parent)
    , search_(
          makeSearchLine(tr("Filter sensors"), tr("Shows only sensors and values whose name contains this"), this)) {
    setAccessibleName(tr("Sensors"));
    setFocusProxy(tree_);
    filtered_->setSourceModel(model_);
    filtered_->setRecursiveFilteringEnabled(true);
    filtered_->setAutoAcceptChildRows(true);
    filtered_->setFilterCaseSensitivity(Qt::CaseInsensitive);
    filtered_->setSortRole(SensorModel::SortRole);
    filtered_->sort(SensorModel::Name);
    setWallClock([] { return Seconds(std::chrono::steady_clock::now().time_since_epoch()); });
    makeTree();
    empty_state_->setText(tr("No sensor data yet"),
                          tr("Every value that the robot sends appears here once it is spawned."));
    laidOut(new QVBoxLayout(this), {}, gap::tiny, {search_, tree_})->setStretchFactor(tree_, 1);
    showEmpty(true);
    connect(search_, &QLineEdit::textChanged, filtered_, &QSortFilterProxyModel::setFilterFixedString);
    connect(filtered_, &QAbstractItemModel::rowsInserted, this, [this](const QModelIndex& branch) {
        if (filtered_->rowCount(branch) > 0)
            tree_->expand(branch);
    });
    frame_.setInterval(std::chrono::milliseconds(100));
    connect(&frame_, &QTimer::timeout, this, &SensorPanel::refresh);
    onThemeChange(this, [this] { tree_->viewport()->update(); });
}

void SensorPanel::makeTree() {
    tree_->setModel(filtered_);
    tree_->setAccessibleName(tr("Sensor values"));
    tree_->setUniformRowHeights(true);
    tree_->setAlternatingRowColors(true);
    tree_->setIndentation(gap::medium);
    tree_->setFrameShape(QFrame::NoFrame);
    tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    tree_->setDragDropMode(QAbstractItemView::DragOnly);
    tree_->setExpandsOnDoubleClick(true);
    QHeaderView* header = tree_->header();
    header->setStretchLastSection(false);
    header->setSectionResizeMode(SensorModel::Name, QHeaderView::Stretch);
    header->setMinimumSectionSize(24);
    const QFontMetrics metrics(themeFont());
    const std::pair<int, QString> widths[] = {{SensorModel::Value, QStringLiteral("−0000.00")},
                                              {SensorModel::Unit, QStringLiteral("m/s")},
                                              {SensorModel::Age, QStringLiteral("answer")},
                                              {SensorModel::Rate, QStringLiteral("00.0 Hz")}};
    for (const auto& [section, sample] : widths)
        header->resizeSection(section, metrics.horizontalAdvance(sample) + gap::small);
    connect(tree_, &QTreeView::activated, this, &SensorPanel::plot);
}

void SensorPanel::take(const protocol::InfoLine& line, Seconds now) {
    newest_.take(line, now);
    heard(now);
}

void SensorPanel::setNow(Seconds now) {
    if (now != now_)
        heard(now);
}

void SensorPanel::heard(Seconds now) {
    if (now != now_)
        pace_ = silence();
    now_ = now;
    heard_at_ = wall_clock_();
}

void SensorPanel::setPaused(bool paused) {
    if (paused_ && !paused)
        heard_at_ = wall_clock_(); // The pause itself does not count as silence.
    paused_ = paused;
}

void SensorPanel::setWallClock(std::function<Seconds()> wall_clock) {
    wall_clock_ = std::move(wall_clock);
    heard_at_ = wall_clock_();
}

bool SensorPanel::silent() const {
    const Seconds limit = std::clamp(2.0 * pace_, protocol::silence::robot, Seconds(10.0));
    return !linked_ || (!paused_ && silence() > limit);
}

void SensorPanel::clear() {
    newest_.takeAll();
    model_->clear();
    showEmpty(true);
}

void SensorPanel::showEmpty(bool empty) {
    empty_state_->setVisible(empty);
    search_->setHidden(empty);
    tree_->setHeaderHidden(empty);
}

void SensorPanel::refresh() {
    const auto lines = newest_.takeAll();
    const std::pair showing(now_, silent());
    if (std::exchange(shown_, showing) == showing && lines.empty() && !silent())
        return; // Only in silence do ages grow between messages.
    for (const CountedLine& counted : lines)
        model_->take(counted.line, counted.now, counted.count);
    model_->flush(silent() ? now_ + silence() : now_, !silent());
    showEmpty(model_->rowCount() == 0);
}

void SensorPanel::plot(const QModelIndex& index) {
    if (index.data(SensorModel::NumericRole).toBool())
        emit plotRequested(index.data(SensorModel::PathRole).toString(), index.data(SensorModel::UnitRole).toString());
}

void SensorPanel::showEvent(QShowEvent* event) {
    refresh();
    frame_.start();
    QWidget::showEvent(event);
}

void SensorPanel::hideEvent(QHideEvent* event) {
    frame_.stop();
    QWidget::hideEvent(event);
}

} // namespace usar::widgets
