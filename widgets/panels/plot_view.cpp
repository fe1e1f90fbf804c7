#include "widgets/panels/plot_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QBuffer>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMenu>
#include <QMimeData>
#include <QSaveFile>

#include "core/base/hand_over.h"
#include "widgets/models/plot/plot_texts.h"
#include "widgets/panels/dialogs.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

namespace {

constexpr int frame_ms = 33;
constexpr double large_step_px = 20.0;
const QString canvases_key = QStringLiteral("canvases"); // As in plot_layout.h.

bool isOwnKey(const QKeyEvent& event) {
    constexpr int keys[] = {Qt::Key_Space, Qt::Key_F, Qt::Key_Plus, Qt::Key_Equal,  Qt::Key_Minus,  Qt::Key_Left,
                            Qt::Key_Right, Qt::Key_A, Qt::Key_B,    Qt::Key_Delete, Qt::Key_Return, Qt::Key_Enter};
    const bool plain = !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    return plain && std::ranges::find(keys, event.key()) != std::end(keys);
}

/// Writes a file in one step; returns the sentence for a failure, or nothing.
QString written(const QString& file, const QByteArray& bytes) {
    QSaveFile out(file);
    if (!bytes.isEmpty() && out.open(QIODevice::WriteOnly) && out.write(bytes) == bytes.size() && out.commit())
        return {};
    const std::string reason = bytes.isEmpty() ? "the picture is too large" : out.errorString().toStdString();
    return QString::fromStdString(failure("the plots cannot be written: " + reason, file.toStdString(),
                                          "Choose another folder, or make room there")
                                      .value()
                                      .text());
}

QByteArray pngOf(const QImage& image) {
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    return image.save(&bytes, "PNG") ? bytes.data() : QByteArray();
}

} // namespace

PlotView::PlotView(QWidget* parent)
    : QWidget(parent)
    , canvas_(new PlotCanvas(model_, this))
    , legend_(new PlotLegend(this))
    , halves_(new QSplitter(this)) {
    QWidget* const tools = makeTools();
    halves_->addWidget(canvas_);
    halves_->addWidget(legend_);
    halves_->setStretchFactor(0, 1);
    halves_->setSizes({700, 240});
    halves_->setCollapsible(0, false);
    laidOut(new QVBoxLayout(this), {}, 0, {tools, halves_})->setStretchFactor(halves_, 1);
    empty_state_ =
        new EmptyState(canvas_, tr("Nothing plotted yet"),
                       tr("Drag a value here from the sensors, or double-click one; its line grows from then on."));
    empty_state_->setBackgroundRole(QPalette::Base);
    empty_state_->setAutoFillBackground(true);
    setAcceptDrops(true);
    frame_.setSingleShot(true);
    frame_.setInterval(frame_ms);
    connectParts();
    listChanged();
    onThemeChange(this, [this] { listChanged(); });
}

PlotView::~PlotView() {
    disk_.waitForDone();
    delete canvas_; // It reads the model.
}

QWidget* PlotView::makeTools() {
    auto* tools = new QWidget(this);
    pause_ = makeToolButton(tr("Freeze the picture; recording continues (Space)"), tools, "pause");
    follow_ = makeToolButton(tr("Follow the newest values (F, or double-click the plot)"), tools, "follow");
    follow_robot_ = makeToolButton(tr("Follow the selected robot: show the same values of the robot that is selected. "
                                      "Off: each line stays with its robot."),
                                   tools, "robot");
    statistics_ = makeToolButton(tr("Statistics of the visible span, or between the cursors"), tools);
    statistics_->setText(QStringLiteral("Σ"));
    auto* add = makeToolButton(tr("Add a plot below, with the same axis of time"), tools, "plus");
    remove_canvas_ = makeToolButton(tr("Remove the chosen plot and its lines"), tools, "minus");
    auto* clear_button = makeToolButton(tr("Remove all lines"), tools, "clear");
    export_ = makeToolButton(tr("Save the plots as a page, a picture or a table"), tools, "export");
    for (QToolButton* toggle : {pause_, follow_, follow_robot_, statistics_})
        toggle->setCheckable(true);
    window_ = new QComboBox(tools);
    fillWindowChoice();
    fillExportMenu();
    laidOut(new QHBoxLayout(tools), {gap::tiny, gap::tiny, gap::tiny, gap::tiny}, gap::tiny,
            {pause_, follow_, window_, follow_robot_, statistics_, add, remove_canvas_, clear_button, export_,
             readout_ = new ElidedLabel(tools)})
        ->setStretchFactor(readout_, 1);
    readout_->setProperty("role", "muted");
    readout_->setAccessibleName(tr("Time at the mouse"));
    readout_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    connect(add, &QToolButton::clicked, this, &PlotView::addCanvas);
    connect(remove_canvas_, &QToolButton::clicked, this, &PlotView::removeCanvas);
    connect(clear_button, &QToolButton::clicked, this, &PlotView::clear);
    return tools;
}

void PlotView::fillWindowChoice() {
    named(window_, tr("Time span that is shown while following"), tr("Time span that is shown while following"));
    window_->setMinimumHeight(minimum_target);
    for (const double seconds : {10.0, 30.0, 60.0, 300.0, 1800.0, 7200.0})
        window_->addItem(seconds < 60.0     ? tr("%1 s").arg(seconds)
                         : seconds < 3600.0 ? tr("%1 min").arg(seconds / 60.0)
                                            : tr("%1 h").arg(seconds / 3600.0),
                         seconds);
    window_->addItem(tr("All"), std::numeric_limits<double>::infinity());
}

void PlotView::fillExportMenu() {
    auto* menu = new QMenu(export_);
    const auto offer = [&](const QString& text, const QString& title, const QString& filter) {
        menu->addAction(text, this, [this, title, filter] { askForFile(title, filter); });
    };
    offer(tr("Save page (PDF)…"), tr("Save page"), QStringLiteral("PDF (*.pdf)"));
    offer(tr("Save picture (PNG)…"), tr("Save picture"), QStringLiteral("PNG (*.png)"));
    offer(tr("Save values (CSV)…"), tr("Save values"), QStringLiteral("CSV (*.csv)"));
    export_->setMenu(menu);
    export_->setPopupMode(QToolButton::InstantPopup);
}

void PlotView::connectParts() {
    legend_->installEventFilter(this);
    connect(&frame_, &QTimer::timeout, this, &PlotView::refresh);
    connect(canvas_, &PlotCanvas::followingChanged, follow_, &QToolButton::setChecked);
    connect(canvas_, &PlotCanvas::momentRequested, this, &PlotView::momentRequested);
    for (const auto changed : {&PlotCanvas::readoutChanged, &PlotCanvas::cursorsChanged})
        connect(canvas_, changed, this, [this] {
            showValues();
            showReadout();
        });
    connect(legend_, &PlotLegend::removeRequested, this, &PlotView::removeSelected);
    connect(legend_, &PlotLegend::columnsChanged, this, &PlotView::giveTableRoom);
    connect(legend_, &QTreeWidget::itemSelectionChanged, this, [this] {
        std::set<SeriesKey> keys;
        for (const ShownSeries& row : legend_->selectedRows())
            keys.insert(row.key);
        canvas_->emphasize(keys);
    });
    connect(pause_, &QToolButton::toggled, this, [this](bool on) {
        model_.setFrozen(on);
        refreshSoon();
    });
    connect(follow_, &QToolButton::toggled, canvas_, &PlotCanvas::setFollowing);
    connect(follow_robot_, &QToolButton::toggled, this, [this](bool on) {
        model_.setFollowRobot(on);
        listChanged();
    });
    connect(statistics_, &QToolButton::toggled, this, [this](bool on) {
        model_.setStatistics(on);
        showValues();
    });
    connect(window_, &QComboBox::currentIndexChanged, this, [this] {
        model_.setWindow(window_->currentData().toDouble());
        follow_->setChecked(true);
        canvas_->setFollowing(true);
    });
}

void PlotView::removeSelected() {
    const QJsonArray before = canvases();
    const auto rows = legend_->selectedRows();
    for (const ShownSeries& row : rows)
        model_.remove(row.canvas, row.key);
    endEdit(rows.size() == 1 ? tr("remove %1 from plots").arg(QString::fromStdString(rows.front().key.path))
                             : tr("remove %1 lines from plots").arg(rows.size()),
            before);
}

void PlotView::addSeries(const QString& path, const QString& unit) {
    addAll({path}, unit);
}

void PlotView::addAll(const QStringList& paths, const QString& unit) {
    const QJsonArray before = canvases();
    for (const QString& path : paths)
        model_.add(canvas_->chosen(), path.toStdString(), unit.toStdString());
    endEdit(paths.size() == 1 ? tr("plot %1").arg(paths.front()) : tr("plot %1 values").arg(paths.size()), before);
}

void PlotView::clear() {
    const QJsonArray before = canvases();
    model_.clear();
    endEdit(tr("remove all lines from plots"), before);
}

void PlotView::addCanvas() {
    const QJsonArray before = canvases();
    if (!model_.addCanvas())
        return;
    canvas_->draw();
    canvas_->choose(model_.layout().canvases.size() - 1);
    endEdit(tr("add plot"), before);
}

void PlotView::removeCanvas() {
    const QJsonArray before = canvases();
    if (!model_.removeCanvas(canvas_->chosen()))
        return;
    canvas_->draw();
    endEdit(tr("remove plot"), before);
}

QJsonArray PlotView::canvases() const {
    return plotLayout()[canvases_key].toArray();
}

void PlotView::setCanvases(const QJsonArray& canvases) {
    QJsonObject layout = plotLayout();
    layout[canvases_key] = canvases;
    [[maybe_unused]] const bool own = setPlotLayout(layout).has_value();
    Q_ASSERT(own);
}

void PlotView::endEdit(const QString& text, const QJsonArray& before) {
    const QJsonArray after = canvases();
    if (after == before)
        return;
    listChanged();
    emit edited(text, before, after);
}

void PlotView::restart(const QString& robot) {
    model_.restart(robot.toStdString());
    refreshSoon();
}

void PlotView::setRobot(const QString& robot) {
    if (model_.robot() == robot.toStdString())
        return;
    model_.setRobot(robot.toStdString());
    listChanged();
}

void PlotView::take(const QString& robot, const protocol::InfoLine& line, Seconds now) {
    if (model_.take(robot.toStdString(), line, now) && !paused())
        refreshSoon();
}

void PlotView::setMoment(std::optional<Seconds> time) {
    canvas_->setMoment(time ? std::optional(time->count()) : std::nullopt);
}

Result<void> PlotView::setPlotLayout(const QJsonObject& layout) {
    Result<PlotLayout> read = plotLayoutFrom(layout);
    if (!read)
        return tl::unexpected(read.error());
    model_.setLayout(std::move(*read));
    canvas_->draw();
    listChanged();
    return {};
}

void PlotView::save(const QString& file) {
    const auto end = [this, file](const QString& trouble) {
        QMetaObject::invokeMethod(this, HandedOver([this, file, trouble] {
                                      if (!trouble.isEmpty())
                                          return emit failed(trouble);
                                      readout_->setText(tr("Saved %1").arg(QFileInfo(file).fileName()));
                                      emit saved(file);
                                  }),
                                  Qt::QueuedConnection);
    };
    const QString suffix = QFileInfo(file).suffix().toLower();
    const QString title =
        tr("%1, %2 to %3")
            .arg(model_.robot().empty() ? tr("Plots") : QString::fromStdString(model_.robot()),
                 momentText(canvas_->visibleFrom().count()), momentText(canvas_->visibleTo().count()));
    if (suffix == QStringLiteral("csv"))
        disk_.start(HandedOver(
            [file, end, table = tableOf(model_)] { end(written(file, QByteArray::fromStdString(csvOf(table)))); }));
    else if (suffix == QStringLiteral("pdf"))
        disk_.start(HandedOver([file, end, page = canvas_->pdf(title)] { end(written(file, page)); }));
    else if (suffix == QStringLiteral("png"))
        disk_.start(
            HandedOver([file, end, image = canvas_->picture(title).toImage()] { end(written(file, pngOf(image))); }));
    else
        end(tr("%1: the name does not say what to write. End it in .pdf, .png or .csv.").arg(file));
}

void PlotView::askForFile(const QString& title, const QString& filter) {
    askWhereToSave(this, title, {}, filter, [this](const QString& file) { save(file); });
}

void PlotView::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasFormat(QLatin1String(field_mime_type)))
        event->acceptProposedAction();
}

// The canvas that would take the values is marked while they hang over it.
void PlotView::dragMoveEvent(QDragMoveEvent* event) {
    canvas_->choose(canvas_->canvasAt(canvas_->mapFrom(this, event->position().toPoint())));
    event->acceptProposedAction();
}

void PlotView::dropEvent(QDropEvent* event) {
    canvas_->choose(canvas_->canvasAt(canvas_->mapFrom(this, event->position().toPoint())));
    const QString paths = QString::fromUtf8(event->mimeData()->data(QLatin1String(field_mime_type)));
    addAll(paths.split(u'\n', Qt::SkipEmptyParts), {});
    event->acceptProposedAction();
}

bool PlotView::event(QEvent* event) {
    // The window has shortcuts on some of these keys; with the focus in the view they control the plot.
    if (event->type() == QEvent::ShortcutOverride && isOwnKey(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

bool PlotView::eventFilter(QObject* watched, QEvent* event) {
    // A tree view would use letters for its own search. Delete is for its rows.
    if (watched == legend_ && event->type() == QEvent::KeyPress) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if (key.key() != Qt::Key_Delete)
            return runKey(key);
        removeSelected();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

bool PlotView::runArrow(int direction, bool far) {
    if (!canvas_->moveCursor(direction * (far ? large_step_px : 1.0)))
        canvas_->panTime(0.1 * direction);
    return true;
}

bool PlotView::runKey(const QKeyEvent& event) {
    if (!isOwnKey(event))
        return false;
    switch (event.key()) {
    case Qt::Key_Space:
        pause_->toggle();
        return true;
    case Qt::Key_F:
        follow_->toggle();
        return true;
    case Qt::Key_A:
    case Qt::Key_B:
        canvas_->placeCursor(event.key() == Qt::Key_A ? CursorName::A : CursorName::B);
        return true;
    case Qt::Key_Left:
    case Qt::Key_Right:
        return runArrow(event.key() == Qt::Key_Left ? -1 : 1, event.modifiers() & Qt::ShiftModifier);
    case Qt::Key_Delete:
        return canvas_->removeCursor();
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (const PlotCursors& cursors = model_.cursors(); cursors.active && canvas_->moment_s())
            emit momentRequested(Seconds(*cursors.at_s(*cursors.active)));
        return true;
    default:
        canvas_->zoomTime(event.key() == Qt::Key_Minus ? 0.8 : 1.25);
        return true;
    }
}

void PlotView::keyPressEvent(QKeyEvent* event) {
    if (!runKey(*event))
        QWidget::keyPressEvent(event);
}

void PlotView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refreshSoon();
}

void PlotView::listChanged() {
    legend_->rebuild(model_);
    showTools();
    showValues();
    refreshSoon();
}

void PlotView::showTools() {
    const PlotLayout& layout = model_.layout();
    const std::pair<QToolButton*, bool> toggles[] = {
        {follow_, canvas_->following()}, {follow_robot_, layout.follow_robot}, {statistics_, layout.statistics}};
    for (const auto& [toggle, on] : toggles) {
        const QSignalBlocker quiet(toggle);
        toggle->setChecked(on);
    }
    const QSignalBlocker quiet(window_);
    const int entry = window_->findData(layout.window_s);
    window_->setCurrentIndex(entry >= 0 ? entry : 2);
    const bool several = layout.canvases.size() > 1;
    remove_canvas_->setEnabled(several);
    legend_->setVisible(!model_.empty());
    export_->setEnabled(!model_.empty());
    empty_state_->setVisible(model_.empty() && !several);
}

void PlotView::giveTableRoom() {
    const int whole = halves_->width();
    const int table = std::min(legend_->wantedWidth() + 2 * gap::small, whole / 2);
    if (whole > 0)
        halves_->setSizes({whole - table, table});
}

void PlotView::showReadout() {
    const std::optional<Seconds> mouse = canvas_->mouseTime();
    const bool cursors = model_.cursors().a_s || model_.cursors().b_s;
    readout_->setText(mouse     ? tr("at %1").arg(momentText(mouse->count()))
                      : cursors ? tr("Drag a cursor or use the arrow keys · Delete removes it")
                                : tr("Wheel zooms · drag moves · click and Shift+click measure"));
}

void PlotView::showValues() {
    const std::optional<Seconds> mouse = canvas_->mouseTime();
    legend_->showValues(model_, {mouse ? std::optional(mouse->count()) : std::nullopt, canvas_->visibleFrom().count(),
                                 canvas_->visibleTo().count()});
}

void PlotView::refreshSoon() {
    if (isVisible() && !frame_.isActive())
        frame_.start();
}

void PlotView::refresh() {
    if (!isVisible())
        return;
    canvas_->draw();
    showValues();
    showReadout();
}

} // namespace usar::widgets
