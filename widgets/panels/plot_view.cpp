#include "widgets/panels/plot_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QDragEnterEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QSaveFile>
#include <QSplitter>

#include "widgets/models/figures.h"
#include "widgets/models/parameter_display.h"
#include "widgets/panels/dialogs.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

namespace {

constexpr int frame_ms = 33;
constexpr int path_role = Qt::UserRole;

QIcon swatch(const QColor& color) {
    QPixmap pixmap(16, 16);
    pixmap.fill(Qt::transparent);
    QPainter(&pixmap).fillRect(QRect(1, 6, 14, 4), color);
    return pixmap;
}

/// Returns a path in words: "Sonar F1 range"; the repeated name in "INS/INS/yaw" is shown once.
QString spoken(QString path) {
    if (path.startsWith(QStringLiteral("SEN ")))
        path.remove(0, 4);
    QStringList parts = path.split(u'/', Qt::SkipEmptyParts);
    if (parts.size() > 2 && parts[0] == parts[1])
        parts.removeFirst();
    return parts.join(u' ').simplified();
}

bool isOwnKey(const QKeyEvent& event) {
    constexpr int keys[] = {Qt::Key_Space, Qt::Key_F,    Qt::Key_Plus, Qt::Key_Equal,
                            Qt::Key_Minus, Qt::Key_Left, Qt::Key_Right};
    const bool plain = !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    return plain && std::ranges::find(keys, event.key()) != std::end(keys);
}

Result<void> written(const QString& file, const QByteArray& bytes) {
    QSaveFile out(file);
    if (out.open(QIODevice::WriteOnly) && out.write(bytes) == bytes.size() && out.commit())
        return {};
    return failure("Cannot write the plot: " + out.errorString().toStdString(), file.toStdString(),
                   "Choose another folder or free some space");
}

} // namespace

PlotView::PlotView(QWidget* parent) : QWidget(parent) {
    QWidget* const tools = makeTools();
    auto* halves = new QSplitter(this);
    halves->addWidget(canvas_);
    halves->addWidget(makeLegend());
    halves->setStretchFactor(0, 1);
    halves->setSizes({700, 240});
    halves->setCollapsible(0, false);
    laidOut(new QVBoxLayout(this), {}, 0, {tools, halves})->setStretchFactor(halves, 1);
    empty_state_ =
        new EmptyState(canvas_, tr("Nothing plotted yet"),
                       tr("Drag a value here from the sensors, or double-click one; its line grows from then on."));
    empty_state_->setBackgroundRole(QPalette::Base);
    empty_state_->setAutoFillBackground(true);
    setAcceptDrops(true);
    frame_.setSingleShot(true);
    frame_.setInterval(frame_ms);
    connect(&frame_, &QTimer::timeout, this, &PlotView::refresh);
    connect(canvas_, &PlotCanvas::followingChanged, follow_, &QToolButton::setChecked);
    connect(canvas_, &PlotCanvas::cursorMoved, this, [this] {
        updateLegendValues();
        showReadout();
    });
    rebuildLegend();
    onThemeChange(this, [this] { rebuildLegend(); });
}

QWidget* PlotView::makeTools() {
    auto* tools = new QWidget(this);
    pause_ = makeToolButton(tr("Freeze the picture; recording continues (Space)"), tools, "pause");
    follow_ = makeToolButton(tr("Follow the newest values (F, or double-click the plot)"), tools, "follow");
    auto* clear_button = makeToolButton(tr("Remove all lines"), tools, "clear");
    export_ = makeToolButton(tr("Save the plot as a picture or a table"), tools, "export");
    for (QToolButton* toggle : {pause_, follow_})
        toggle->setCheckable(true);
    follow_->setChecked(true);
    window_ = new QComboBox(tools);
    fillWindowChoice();
    auto* menu = new QMenu(export_);
    menu->addAction(tr("Save picture (PNG)…"), this, [this] {
        askForFile(tr("Save picture"), QStringLiteral("PNG (*.png)"), &PlotView::exportPicture);
    });
    menu->addAction(tr("Save values (CSV)…"), this,
                    [this] { askForFile(tr("Save values"), QStringLiteral("CSV (*.csv)"), &PlotView::exportCsv); });
    export_->setMenu(menu);
    export_->setPopupMode(QToolButton::InstantPopup);
    laidOut(new QHBoxLayout(tools), {gap::tiny, gap::tiny, gap::tiny, gap::tiny}, gap::tiny,
            {pause_, follow_, window_, clear_button, export_, readout_ = new ElidedLabel(tools)})
        ->setStretchFactor(readout_, 1);
    readout_->setProperty("role", "muted");
    readout_->setAccessibleName(tr("Time at the mouse"));
    readout_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    showReadout();
    connect(pause_, &QToolButton::toggled, this, &PlotView::refreshSoon);
    connect(follow_, &QToolButton::toggled, canvas_, &PlotCanvas::setFollowing);
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
    window_->setCurrentIndex(2);
    connect(window_, &QComboBox::currentIndexChanged, this, [this] {
        canvas_->setWindow(Seconds(window_->currentData().toDouble()));
        follow_->setChecked(true);
    });
}

QWidget* PlotView::makeLegend() {
    legend_->setColumnCount(2);
    legend_->setHeaderHidden(true);
    legend_->installEventFilter(this);
    legend_->setRootIsDecorated(false);
    legend_->setUniformRowHeights(true);
    legend_->setFrameShape(QFrame::NoFrame);
    legend_->setTextElideMode(Qt::ElideMiddle);
    legend_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    legend_->setContextMenuPolicy(Qt::CustomContextMenu);
    legend_->setAccessibleName(tr("Plotted values"));
    legend_->header()->setStretchLastSection(false);
    legend_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    legend_->header()->setSectionResizeMode(1, QHeaderView::Fixed);
    legend_->header()->resizeSection(1, 76);
    connect(addRowAction(legend_, tr("Remove from the plot"), QKeySequence::Delete), &QAction::triggered, this,
            &PlotView::removeSelected);
    connect(legend_, &QWidget::customContextMenuRequested, this,
            [this](const QPoint& at) { popUpRowMenu(legend_, at); });
    connect(legend_, &QTreeWidget::itemSelectionChanged, this, [this] {
        std::set<std::string> paths;
        for (const QTreeWidgetItem* item : legend_->selectedItems())
            paths.insert(item->data(0, path_role).toString().toStdString());
        canvas_->emphasize(paths);
    });
    return legend_;
}

void PlotView::removeSelected() {
    for (const QTreeWidgetItem* item : legend_->selectedItems())
        store_.remove(item->data(0, path_role).toString().toStdString());
    listChanged();
}

void PlotView::addSeries(const QString& path, const QString& unit) {
    if (store_.add(path.toStdString(), unit.toStdString()))
        listChanged();
}

void PlotView::clear() {
    store_.clear();
    listChanged();
}

void PlotView::restart() {
    store_.startAgain();
    refreshSoon();
}

void PlotView::setSource(const QString& robot_name) {
    legend_->setHeaderLabels({robot_name, QString()});
    legend_->setHeaderHidden(robot_name.isEmpty());
}

void PlotView::take(const protocol::InfoLine& line, Seconds now) {
    if (store_.take(line, now) && !paused())
        refreshSoon();
}

Result<void> PlotView::exportCsv(const QString& file) const {
    return written(file, QByteArray::fromStdString(csvOf(store_.series())));
}

Result<void> PlotView::exportPicture(const QString& file) const {
    if (canvas_->picture().save(file, "PNG"))
        return {};
    return failure("Cannot write the picture", file.toStdString(), "Choose another folder or free some space");
}

void PlotView::askForFile(const QString& title, const QString& filter,
                          Result<void> (PlotView::*write)(const QString&) const) {
    askWhereToSave(this, title, {}, filter, [this, write](const QString& file) {
        if (const Result<void> done = (this->*write)(file); !done)
            emit failed(QString::fromStdString(done.error().text()));
    });
}

void PlotView::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasFormat(QLatin1String(field_mime_type)))
        event->acceptProposedAction();
}

void PlotView::dropEvent(QDropEvent* event) {
    const QString paths = QString::fromUtf8(event->mimeData()->data(QLatin1String(field_mime_type)));
    for (const QString& path : paths.split(u'\n', Qt::SkipEmptyParts))
        addSeries(path);
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
    // A tree view would use letters for its own search.
    if (watched == legend_ && event->type() == QEvent::KeyPress && runKey(*static_cast<QKeyEvent*>(event)))
        return true;
    return QWidget::eventFilter(watched, event);
}

bool PlotView::runKey(const QKeyEvent& event) {
    if (!isOwnKey(event))
        return false;
    if (event.key() == Qt::Key_Space)
        pause_->toggle();
    else if (event.key() == Qt::Key_F)
        follow_->toggle();
    else if (event.key() == Qt::Key_Left || event.key() == Qt::Key_Right)
        canvas_->panTime(event.key() == Qt::Key_Left ? -0.1 : 0.1);
    else
        canvas_->zoomTime(event.key() == Qt::Key_Minus ? 0.8 : 1.25);
    return true;
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
    rebuildLegend();
    refreshSoon();
}

void PlotView::rebuildLegend() {
    legend_->clear();
    int index = 0;
    for (const Series& series : store_.series()) {
        const QString path = QString::fromStdString(series.path);
        auto* item = new QTreeWidgetItem(legend_, {spoken(path), QString()});
        item->setIcon(0, swatch(PlotCanvas::lineColor(index++)));
        item->setData(0, path_role, path);
        item->setToolTip(0, path);
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        item->setSizeHint(0, QSize(0, minimum_target));
    }
    legend_->setVisible(!store_.series().empty());
    export_->setEnabled(!store_.series().empty());
    empty_state_->setVisible(store_.series().empty());
    updateLegendValues();
}

void PlotView::showReadout() {
    const std::optional<Seconds> cursor = canvas_->cursor();
    const auto tenths = std::llround(10.0 * cursor.value_or(Seconds(0.0)).count());
    readout_->setText(cursor ? tr("at %1.%2").arg(clockText(Seconds(static_cast<double>(tenths / 10)))).arg(tenths % 10)
                             : tr("Wheel zooms · drag moves · double-click follows"));
}

void PlotView::updateLegendValues() {
    const std::optional<Seconds> cursor = canvas_->cursor();
    for (int row = 0; row < legend_->topLevelItemCount(); ++row) {
        const Series& series = store_.series()[static_cast<std::size_t>(row)];
        const DisplayUnit unit = displayUnit(series.unit);
        const double time_s = cursor ? cursor->count() : std::numeric_limits<double>::infinity();
        const double value = valueAt(series, time_s).value_or(std::nan("")) * unit.factor;
        legend_->topLevelItem(row)->setText(1, figure(value, 2) + u' ' + unit.text);
    }
}

void PlotView::refreshSoon() {
    if (isVisible() && !frame_.isActive())
        frame_.start();
}

void PlotView::refresh() {
    if (!isVisible())
        return;
    updateLegendValues();
    showReadout();
    if (paused())
        canvas_->dropLines(store_);
    else
        canvas_->show(store_);
}

} // namespace usar::widgets
