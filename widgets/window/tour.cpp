#include "widgets/window/tour.h"

#include <algorithm>
#include <chrono>

#include <QApplication>
#include <QKeyEvent>
#include <QWindow>

#include "widgets/map/map_labels.h"
#include "widgets/map/map_overlay.h"

namespace usar::widgets {

namespace {

constexpr std::chrono::milliseconds glance{100};
constexpr std::chrono::milliseconds time_to_see{900};

} // namespace

Tour::Tour(QMainWindow& window, const WindowViews& views)
    : window_(window)
    , views_(views)
    , ring_(new TourRing(&window))
    , card_(new TourCard(&window)) {
    makeSteps();
    step_ = steps_.size();
    watch_.setInterval(glance);
    tick_.setSingleShot(true);
    tick_.setInterval(time_to_see);
    connect(&watch_, &QTimer::timeout, this, &Tour::look);
    connect(&tick_, &QTimer::timeout, this, &Tour::next);
    connect(card_, &TourCard::nextRequested, this, &Tour::next);
    connect(card_, &TourCard::leaveRequested, this, &Tour::leave);
    connect(views.hint, &HintStrip::tourRequested, this, &Tour::begin);
    connect(views.behavior->choice(), &QComboBox::activated, this, [this] { behavior_chosen_ = true; });
}

void Tour::makeSteps() {
    QDockWidget* const behavior = views_.docks[1];
    MapView* const map = views_.map;
    steps_.push_back({tr("Start the simulator"),
                      tr("A simulator runs inside this program, and this bar connects to it. For a USARSim server on "
                         "the network, disconnect and choose Real server."),
                      nullptr, [this] { return placeOf(views_.connection); },
                      [map] { return !map->content().start_poses.empty(); }});
    steps_.push_back({tr("Click a start pose"),
                      tr("Each diamond on the map is a start pose. Double-click one to spawn a robot there; a single "
                         "click lets you choose its class and name first."),
                      nullptr, [this] { return startPose(); },
                      [this] { return views_.robots->model().rowCount() > 0; }});
    steps_.push_back({tr("Choose a behavior"),
                      tr("A behavior is what a robot does by itself, such as flying over an area in lanes. Choose one "
                         "here; its parameters are below."),
                      behavior, [this] { return placeOf(views_.behavior->choice()); },
                      [this] { return behavior_chosen_; }});
    steps_.push_back({tr("Start it"),
                      tr("If there is no area yet, press Draw and drag a rectangle on the map: this is what the robot "
                         "scans. Then press Start."),
                      behavior, [this] { return wayToStart(); }, [this] { return views_.behavior->busy(); }});
    steps_.push_back({tr("Watch the scan"),
                      tr("The map fills with the heights that the robot measures; the legend tells what the colors "
                         "mean. STOP ALL, or Escape twice, stops every robot at once."),
                      nullptr, [this] { return placeOf(views_.map); }, [map] { return !map->heights().empty(); }});
}

void Tour::begin() {
    setTaken(true);
    qApp->installEventFilter(this);
    watch_.start();
    show(0);
    card_->next()->setFocus(Qt::OtherFocusReason);
}

void Tour::leave() {
    if (!running())
        return;
    step_ = steps_.size();
    qApp->removeEventFilter(this);
    watch_.stop();
    tick_.stop();
    ring_->hide();
    card_->hide();
    views_.map->setFocus(Qt::OtherFocusReason);
}

void Tour::setTaken(bool taken) {
    taken_ = taken;
    views_.hint->setTourOffered(!taken);
}

void Tour::show(std::size_t step) {
    tick_.stop();
    step_ = step;
    behavior_chosen_ = false;
    if (QDockWidget* const dock = steps_[step].dock) {
        dock->show();
        dock->raise();
    }
    card_->showStep(int(step) + 1, int(steps_.size()), steps_[step].title, steps_[step].text);
    was_done_ = steps_[step].done();
    card_->setDone(was_done_);
    look();
}

void Tour::next() {
    if (step_ + 1 < steps_.size())
        show(step_ + 1);
    else
        leave();
}

void Tour::look() {
    const Step& step = steps_[step_];
    QRect target = step.target();
    if (target.isEmpty())
        target = placeOf(step.dock ? step.dock : static_cast<QWidget*>(views_.map));
    ring_->surround(target);
    if (const QRect dock = step.dock ? placeOf(step.dock) : QRect(); dock.contains(target)) {
        target.setLeft(dock.left()); // The card covers nothing else of the dock.
        target.setRight(dock.right());
    }
    card_->standBeside(target, step_ == 0); // To the right of the first is the time, which runs on.
    card_->raise();
    if (!step.done() || was_done_ || tick_.isActive())
        return;
    card_->setDone(true);
    was_done_ = true;
    if (step_ + 1 < steps_.size()) // The last one is read until the person ends it.
        tick_.start();
}

QRect Tour::placeOf(const QWidget* widget) const {
    if (widget->window() != &window_)
        return {};
    return widget->visibleRegion().boundingRect().translated(widget->mapTo(&window_, QPoint()));
}

QRect Tour::startPose() const {
    MapView& map = *views_.map;
    const MapContent& content = map.content();
    const auto taken = OverlayPlaces(legendsOf(content, map.heights()), map.transform()).all();
    const MapLabels labels = placeMapLabels(content, map.transform(), taken);
    std::vector<QRectF> places;
    for (std::size_t i = 0; i < content.start_poses.size(); ++i) {
        const QPointF at = map.transform().toScreen(content.start_poses[i].pose_in_map.position_m.head<2>());
        constexpr double half = symbol::arrow_px + 3.0;
        QRectF place(at - QPointF(half, half), QSizeF(2.0 * half, 2.0 * half));
        if (i < labels.start_poses.size() && labels.start_poses[i])
            place |= labels.start_poses[i]->adjusted(-3.0, -3.0, 3.0, 3.0);
        places.push_back(place);
    }
    const auto isFree = [&](const QRectF& place) {
        return QRectF(map.rect()).contains(place) &&
               std::ranges::count_if(places, [&](const QRectF& other) { return other.intersects(place); }) == 1;
    };
    const auto free = std::ranges::find_if(places, isFree);
    if (free == places.end())
        return {};
    return free->toAlignedRect().translated(map.mapTo(&window_, QPoint()));
}

QRect Tour::wayToStart() const {
    const BehaviorPanel& panel = *views_.behavior;
    if (views_.map->tool() == MapTool::Area)
        return placeOf(views_.map);
    const bool lacks_area = panel.needsArea() && panel.area().empty();
    return placeOf(lacks_area ? static_cast<const QWidget*>(panel.areaTool()) : panel.startButton());
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &window_ && event->type() == QEvent::Resize)
        look();
    // A window receives each key once, before it is passed on to widgets. Escape has other work in popups, and where
    // a tool of the map is active; and it still counts for STOP ALL.
    if (event->type() == QEvent::KeyPress && watched == window_.windowHandle() && !QApplication::activePopupWidget() &&
        views_.map->tool() == MapTool::Pan && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
        leave();
    return false;
}

} // namespace usar::widgets
