#include "widgets/panels/instrument_panel.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <QVBoxLayout>

#include "widgets/models/figures.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {
namespace {

constexpr int figure_columns = 2; // Three would be wider than a narrow dock.
const QString widest_figure = QStringLiteral("−000.00");

} // namespace

InstrumentPanel::InstrumentPanel(QWidget* parent)
    : QWidget(parent)
    , list_column_(laidOut(new QVBoxLayout, gap::small)) {
    auto* column = laidOut(new QVBoxLayout(this), {gap::small, gap::small, gap::small, gap::small}, gap::small);
    column->addWidget(status_);
    status_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed); // Figures are never squeezed.
    column->addWidget(empty_);
    empty_->setWordWrap(true);
    setRole(empty_, "muted");
    column->addWidget(attitude_, 3);
    figure_grid_->setHorizontalSpacing(gap::medium);
    figure_grid_->setVerticalSpacing(gap::tiny);
    column->addLayout(figure_grid_);
    column->addWidget(laser_, 3);
    column->addWidget(terrain_, 2);
    column->addWidget(ring_, 3);
    column->addWidget(sonars_, 2);
    column->addLayout(list_column_);
    column->addStretch(0);
    clear();
}

void InstrumentPanel::clear() {
    for (QWidget* view : std::initializer_list<QWidget*>{attitude_, laser_, terrain_, ring_, sonars_})
        view->hide();
    for (auto& [caption, readout] : readouts_)
        readout->hide();
    shown_figures_.clear();
    shown_scan_ = {};
    for (ReadingListView* list : lists_)
        list->hide();
    empty_->setText(tr("No robot is selected. Its instruments appear here: those that it has sensors for."));
    empty_->show();
}

void InstrumentPanel::showRobot(const RobotInstruments& robot, Seconds now, bool linked,
                                const agent::SonarZones* judged) {
    showAttitude(robot, now, linked);
    showFigures(robot, now, linked);
    showRanges(robot, now, linked, judged);
    showLists(robot, now, linked);
    showWords(robot, now);
}

void InstrumentPanel::showAttitude(const RobotInstruments& robot, Seconds now, bool linked) {
    const PoseSource* const source = robot.pose().attitude(now);
    attitude_->setVisible(source);
    if (!source)
        return;
    attitude_->setAttitude(source->roll_pitch_yaw_rad, QString::fromStdString(source->type));
    attitude_->setStale(!linked || source->heard.stale(now), source->heard.age(now), source->heard.period);
}

Readout* InstrumentPanel::readout(const InstrumentFigure& figure) {
    Readout*& readout = readouts_[figure.caption];
    if (!readout)
        readout = new Readout(figure.caption, figure.unit, widest_figure, this);
    return readout;
}

void InstrumentPanel::showFigures(const RobotInstruments& robot, Seconds now, bool linked) {
    const std::vector<InstrumentFigure> figures = robot.figures(now);
    QStringList captions;
    for (const InstrumentFigure& figure : figures)
        captions << figure.caption;
    if (captions != shown_figures_) {
        for (auto& [caption, readout] : readouts_) {
            figure_grid_->removeWidget(readout);
            readout->hide();
        }
        for (int i = 0; i < int(figures.size()); ++i) {
            Readout* const one = readout(figures[std::size_t(i)]);
            figure_grid_->addWidget(one, i / figure_columns, i % figure_columns);
            one->show();
        }
        shown_figures_ = captions;
    }
    for (const InstrumentFigure& figure : figures) {
        Readout* const one = readout(figure);
        one->setText(figure.value);
        one->setToolTip(figure.help);
        one->setStale(!linked || figure.heard.stale(now), figure.heard.age(now), figure.heard.period);
    }
}

void InstrumentPanel::showRanges(const RobotInstruments& robot, Seconds now, bool linked,
                                 const agent::SonarZones* judged) {
    laser_->setVisible(robot.scan());
    if (robot.scan()) {
        const std::pair<const void*, Seconds> newest(&robot, robot.scanHeard().last);
        if (std::exchange(shown_scan_, newest) != newest)
            laser_->setScan(*robot.scan(), robot.scanMaximum_m(),
                            robot.scansGround() ? ScanPlane::Below : ScanPlane::Ahead);
        laser_->setStale(!linked || robot.scanHeard().stale(now), robot.scanHeard().age(now), robot.scanHeard().period);
    }
    const agent::SonarZones zones = judged ? *judged : robot.sonars(now);
    const SonarRing ring = robot.ring(zones);
    const Heard& heard = robot.sonarsHeard();
    const bool stale = !linked || heard.stale(now);
    sonars_->setVisible(!zones.zones.empty());
    ring_->setVisible(!ring.cones.empty());
    if (!zones.zones.empty()) {
        sonars_->setZones(zones);
        sonars_->setStale(stale, heard.age(now), heard.period);
    }
    if (!ring.cones.empty()) {
        ring_->setRing(ring);
        ring_->setStale(stale, heard.age(now), heard.period);
    }
}

void InstrumentPanel::showLists(const RobotInstruments& robot, Seconds now, bool linked) {
    const std::vector<ReadingList>& lists = robot.lists();
    while (lists_.size() < lists.size()) {
        auto* const view = new ReadingListView(this);
        list_column_->addWidget(view);
        lists_.push_back(view);
    }
    for (std::size_t i = 0; i < lists_.size(); ++i) {
        lists_[i]->setVisible(i < lists.size());
        if (i < lists.size())
            lists_[i]->setList(lists[i], now, linked);
    }
}

void InstrumentPanel::showWords(const RobotInstruments& robot, Seconds now) {
    empty_->setVisible(robot.empty());
    if (!robot.empty())
        return;
    empty_->setText(robot.settled(now)
                        ? tr("This robot has sent no reading that an instrument could show. Everything that it does "
                             "send is in the dock Sensors.")
                        : tr("Waiting for the robot's first readings. It gets an instrument for each sensor that it "
                             "tells of."));
}

std::vector<const ReadingListView*> InstrumentPanel::lists() const {
    std::vector<const ReadingListView*> shown;
    std::ranges::copy_if(lists_, std::back_inserter(shown),
                         [](const ReadingListView* one) { return !one->isHidden(); });
    return shown;
}

QStringList InstrumentPanel::figures() const {
    return shown_figures_;
}

} // namespace usar::widgets
