#include "widgets/plan/plan_panel.h"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QResizeEvent>
#include <QScopedValueRollback>
#include <QShortcut>
#include <QSignalBlocker>

#include "core/posh/language/plan_reader.h"
#include "widgets/models/plan/plan_places.h"
#include "widgets/plan/plan_parts.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

namespace {

constexpr int narrow_panel_px = 640;
constexpr int node_role = Qt::UserRole;
constexpr int since_role = Qt::UserRole + 9;      // Time of a reason in seconds on the protocol clock; none: invalid.
constexpr int lost_role = Qt::UserRole + 8;       // True for a breakpoint that has no place in the plan.
constexpr int breakpoint_role = Qt::UserRole + 2; // On items of the breakpoint list: its id.

struct Row {
    QString text;
    PlanNodeId node{};
    QIcon icon{};
    int mark = 0; ///< rows with different marks differ even if their text is the same
    std::optional<Seconds> since{};
};

/// Adds or removes items at the end; the others are reused, because one of them may be emitting a signal.
void setItemCount(QListWidget& list, std::size_t count) {
    while (list.count() > static_cast<int>(count))
        delete list.takeItem(list.count() - 1);
    while (list.count() < static_cast<int>(count))
        new QListWidgetItem(&list);
}

/// Changes only the rows that differ, so that neither selection nor scroll position jumps at every tick.
void fill(QListWidget& list, const std::vector<Row>& rows) {
    setItemCount(list, rows.size());
    for (int i = 0; i < list.count(); ++i) {
        const Row& row = rows[static_cast<std::size_t>(i)];
        QListWidgetItem* const item = list.item(i);
        if (item->text() != row.text)
            item->setText(row.text);
        if (item->data(node_role).isNull() || item->data(node_role + 1).toInt() != row.mark)
            item->setIcon(row.icon);
        item->setData(node_role, row.node.value);
        item->setData(node_role + 1, row.mark);
        item->setData(since_role, row.since ? QVariant(row.since->count()) : QVariant());
    }
}

/// Time at which the reason of a row began; nullopt if the row, or its reason, has none.
std::optional<Seconds> sinceOf(const QListWidgetItem* item) {
    const QVariant since_s = item ? item->data(since_role) : QVariant();
    return since_s.isValid() ? std::optional(Seconds(since_s.toDouble())) : std::nullopt;
}

QIcon verdictIcon(PlanVerdict verdict) {
    return verdict == PlanVerdict::Yes  ? icon(QStringLiteral("check"), tokens().ok)
           : verdict == PlanVerdict::No ? icon(QStringLiteral("clear"), tokens().danger)
                                        : icon(QStringLiteral("help"), tokens().text_muted);
}

agent::BreakpointId breakpointOf(const QListWidgetItem& item) {
    return {item.data(breakpoint_role).toInt()};
}

/// `run` is called when the key is pressed in the widget itself.
void addKey(QWidget* widget, const QKeySequence& key, std::function<void()> run) {
    new QShortcut(key, widget, widget, std::move(run), Qt::WidgetShortcut);
}

} // namespace

PlanPanel::PlanPanel(QWidget* parent)
    : QWidget(parent)
    , view_(new PlanView(this))
    , head_(new QBoxLayout(QBoxLayout::LeftToRight))
    , body_(new QSplitter(this))
    , halt_bar_(new PlanHaltBar(this))
    , time_bar_(new PlanTimeBar(this)) {
    setAccessibleName(tr("Plan"));
    laidOut(head_, gap::tiny)->addLayout(makeSearchRow(), 1);
    head_->addLayout(makeButtonRow());
    side_ = new SectionStack(tr("Lists of the plan"), this);
    fillSide();
    body_->addWidget(makeText());
    body_->addWidget(view_);
    body_->addWidget(side_);
    body_->setStretchFactor(1, 1);
    body_->setHandleWidth(gap::small);
    auto* column = laidOut(new QVBoxLayout(this), {gap::small, gap::small, gap::small, gap::small}, gap::tiny);
    // By default the minimum width of the wide row would keep the panel from becoming narrow.
    column->setSizeConstraint(QLayout::SetNoConstraint);
    column->addLayout(head_);
    column->addWidget(halt_bar_);
    column->addWidget(body_, 1);
    column->addWidget(time_bar_);
    connect(view_, &PlanView::refreshed, this, &PlanPanel::showRunning);
    connect(view_, &PlanView::refreshed, this, &PlanPanel::showReasons);
    connect(view_, &PlanView::selectionChanged, this, [this] {
        showReasons();
        // With the focus in one of the lists, the user is still reading there.
        if (view_->selected().valid() && !side_->isAncestorOf(QApplication::focusWidget()))
            side_->show(reasons_);
    });
    connect(view_, &PlanView::selectionChanged, this, &PlanPanel::showFound);
    connect(view_, &PlanView::treeChanged, this, &PlanPanel::showTree);
    connect(view_, &PlanView::refreshed, this, &PlanPanel::showRunningLines);
    connect(view_, &PlanView::selectionChanged, this, &PlanPanel::showTextPlace);
    connect(view_, &PlanView::activated, this, [this] {
        if (text_shown_->isEnabled())
            text_shown_->setChecked(true);
    });
    onThemeChange(this, [this] { // Icons and what has no place have the colors of the theme.
        reasons_->clear();
        showReasons();
        inkBreakpoints();
    });
    side_->hide();
    time_bar_->hide();
    showFound();
    showRunning();
    showReasons();
}

void PlanPanel::showTree() {
    const bool empty = view_->tree().empty();
    if (empty && time_bar_->slider()->hasFocus()) { // Otherwise the search would get the keys until a plan comes.
        slider_waits_ = true;
        view_->setFocus();
    }
    side_->setVisible(!empty);
    time_bar_->setVisible(!empty);
    if (!empty && std::exchange(slider_waits_, false) && view_->hasFocus()) {
        QSlider* const slider = time_bar_->slider();
        slider->setEnabled(true); // It may not know the plan's moments yet, and a disabled slider takes no focus.
        slider->setFocus();
    }
    showRunning();
    search(search_->text());
}

QBoxLayout* PlanPanel::makeSearchRow() {
    search_ = makeSearchLine(tr("Find in the plan"),
                             tr("Names or kinds (drive, competence, element, act, sense, …); Return goes to the next, "
                                "Shift+Return to the previous (Ctrl+F)"),
                             this);
    found_ = mutedLabel({}, this);
    auto* row = laidOut(new QHBoxLayout, gap::tiny, {search_, found_});
    row->setStretchFactor(search_, 1);
    const auto goBack = [this] { view_->findNext(true); };
    const auto goOn = [this] { view_->findNext(); };
    previous_ = addButton(row, "up", tr("Previous match (Shift+Return)"), goBack);
    next_ = addButton(row, "down", tr("Next match (Return)"), goOn);
    connect(search_, &QLineEdit::textChanged, this, &PlanPanel::search);
    addKey(search_, Qt::Key_Return, goOn);
    addKey(search_, Qt::SHIFT | Qt::Key_Return, goBack);
    addKey(search_, Qt::Key_Escape, [this] {
        search_->clear();
        view_->setFocus(Qt::OtherFocusReason);
    });
    return row;
}

QToolButton* PlanPanel::addButton(QBoxLayout* row, const char* icon_name, const QString& help,
                                  const std::function<void()>& clicked) {
    auto* button = makeToolButton(help, this, QString::fromLatin1(icon_name));
    row->addWidget(button);
    if (clicked)
        connect(button, &QToolButton::clicked, this, clicked);
    return button;
}

QBoxLayout* PlanPanel::makeButtonRow() {
    auto* row = laidOut(new QHBoxLayout, gap::tiny);
    text_shown_ = addButton(row, "text", tr("Shows the plan's text beside the drawing"));
    text_shown_->setCheckable(true);
    text_shown_->setEnabled(false);
    QToolButton* const expanded =
        addButton(row, "branches", tr("Draws shared parts in full wherever they are used; otherwise once, with links"));
    expanded->setCheckable(true);
    expanded->setAccessibleName(tr("Draw shared parts everywhere"));
    connect(expanded, &QToolButton::toggled, this, [this](bool on) {
        view_->setSharing(on ? PlanSharing::Expanded : PlanSharing::Once);
        view_->showBeginning();
    });
    addButton(row, "follow", tr("Unfolds what is running and folds the rest"), [this] { view_->showRunning(); });
    addButton(row, "unfold", tr("Unfolds everything"), [this] { view_->unfoldAll(); });
    addButton(row, "fold", tr("Folds everything (Space folds the selected part)"), [this] { view_->foldAll(); });
    addButton(row, "plus", tr("Zooms in (+, or the wheel)"), [this] { view_->zoomIn(); });
    addButton(row, "minus", tr("Zooms out (-)"), [this] { view_->zoomOut(); });
    addButton(row, "fit", tr("Shows the whole plan (F)"), [this] { view_->fit(); });
    addButton(row, "export", tr("Saves the drawing as a picture"), [this] { emit exportRequested(); });
    row->addStretch(1);
    return row;
}

QWidget* PlanPanel::makeText() {
    auto* pane = new QWidget(this);
    text_ = new PlanTextEdit(pane);
    finding_ = makeLabel(pane);
    finding_->hide();
    laidOut(new QVBoxLayout(pane), {}, gap::tiny, {text_, finding_})->setStretchFactor(text_, 1);
    pane->hide();
    connect(text_shown_, &QToolButton::toggled, pane, &QWidget::setVisible);
    connect(text_, &PlanTextEdit::placeEntered, this, [this](int line, int column_number) {
        const QScopedValueRollback from_text(from_text_, true);
        if (const PlanNodeId node = nodeAtPlace(view_->tree(), line, column_number); node.valid())
            view_->select(node);
        showFinding();
    });
    return pane;
}

void PlanPanel::fillSide() {
    running_title_ = makeLabel(side_, "title", tr("Running now"));
    running_ = makeList(tr("Running now"), tr("What is running, from the root down; click to select"));
    side_->add(running_title_, running_, tr("Running"), 2);
    verdict_ = makeLabel(side_, "title");
    reasons_ = makeList(tr("Reasons"), tr("What lets the selected part run, and what prevents it; without a selection, "
                                          "what prevents the drives; click to select, double-click to go to the time "
                                          "when it began"));
    reasons_->setWordWrap(true);
    reasons_->viewport()->installEventFilter(this);
    side_->add(verdict_, reasons_, tr("Why?"), 3);
    side_->setTitleKept(reasons_, true); // It is the answer.
    board_ = makeList(tr("Blackboard"), {});
    side_->add(makeLabel(side_, "title", tr("Blackboard")), board_, tr("Blackboard"), 2);
    connect(board_, &QListWidget::currentRowChanged, this, &PlanPanel::keySelected);
    connect(board_, &QListWidget::itemActivated, this, &PlanPanel::keyActivated);
    showBoard();
    breakpoints_ = makeList(tr("Breakpoints"), tr("The check mark turns one on or off; click to select its part, "
                                                  "double-click to edit it, Delete to remove it"));
    side_->add(makeLabel(side_, "title", tr("Breakpoints")), breakpoints_, tr("Breakpoints"), 2);
    connectBreakpoints();
    setBreakpoints({});
}

void PlanPanel::setSnapshot(PlanSnapshot snapshot) {
    if (snapshot.board != board_values_) {
        board_values_ = snapshot.board;
        showBoard();
    }
    view_->setSnapshot(std::move(snapshot));
}

void PlanPanel::setWatchedKeys(const QStringList& keys) {
    watched_keys_ = keys;
    showBoard();
}

QString PlanPanel::selectedKey() const {
    const int row = board_->currentRow();
    return row >= 0 && row < std::ssize(board_values_) ? board_values_[static_cast<std::size_t>(row)].key : QString();
}

void PlanPanel::showBoard() {
    side_->setSectionShown(board_, !board_values_.empty());
    std::vector<Row> rows;
    for (const BoardValue& one : board_values_) {
        const bool is_watched = watched_keys_.contains(one.key);
        rows.push_back({one.key + " = " + one.value,
                        {},
                        is_watched ? icon(QStringLiteral("record"), tokens().danger) : QIcon(),
                        is_watched ? 2 : 1});
    }
    fill(*board_, rows);
    for (int i = 0; i < board_->count(); ++i)
        board_->item(i)->setToolTip(board_values_[static_cast<std::size_t>(i)].history + '\n' +
                                    tr("Double-click to stop the plan whenever this is written, or to end that."));
}

void PlanPanel::connectBreakpoints() {
    connect(breakpoints_, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        emit breakpointSwitched(breakpointOf(*item), item->checkState() == Qt::Checked);
    });
    connect(breakpoints_, &QListWidget::itemDoubleClicked, this,
            [this](const QListWidgetItem* item) { emit breakpointEditRequested(breakpointOf(*item)); });
    addKey(breakpoints_, QKeySequence::Delete, [this] {
        if (const QListWidgetItem* const item = breakpoints_->currentItem())
            emit breakpointRemoved(breakpointOf(*item));
    });
}

void PlanPanel::setBreakpoints(const std::vector<BreakpointRow>& rows) {
    side_->setSectionShown(breakpoints_, !rows.empty());
    const QSignalBlocker quiet(breakpoints_);
    setItemCount(*breakpoints_, rows.size());
    for (int i = 0; i < breakpoints_->count(); ++i) {
        const BreakpointRow& row = rows[static_cast<std::size_t>(i)];
        QListWidgetItem* const item = breakpoints_->item(i);
        item->setText(row.text);
        item->setToolTip(row.help);
        item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
        item->setCheckState(row.enabled ? Qt::Checked : Qt::Unchecked);
        item->setData(node_role, row.path.empty() ? -1 : view_->tree().find(row.path).value);
        item->setData(breakpoint_role, row.id.value);
        item->setData(lost_role, row.path.empty());
    }
    inkBreakpoints();
}

void PlanPanel::inkBreakpoints() {
    for (int i = 0; i < breakpoints_->count(); ++i) {
        QListWidgetItem* const item = breakpoints_->item(i);
        const bool lost = item->data(lost_role).toBool();
        item->setData(Qt::ForegroundRole, lost ? QVariant(QBrush(tokens().stale)) : QVariant());
    }
}

QListWidget* PlanPanel::makeList(const QString& name, const QString& help) {
    auto* list = named(new QListWidget(this), name, help);
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list->setMinimumHeight(24);
    list->setIconSize({14, 14});
    connect(list, &QListWidget::itemClicked, this, &PlanPanel::jumpTo);
    connect(list, &QListWidget::itemActivated, this, &PlanPanel::activate);
    return list;
}

void PlanPanel::setPlanText(std::string_view text, const posh::Findings& findings) {
    text_->setPlanText(text, findings, notesOf(posh::readPlan(text).plan));
    text_shown_->setEnabled(true);
    if (posh::hasErrors(findings))
        text_shown_->setChecked(true);
    showRunningLines();
    showTextPlace();
    showFinding();
}

void PlanPanel::clear() {
    board_values_.clear();
    showBoard();
    view_->clear();
    text_->setPlanText({}, {});
    text_shown_->setChecked(false);
    text_shown_->setEnabled(false);
}

void PlanPanel::showTextPlace() {
    const PlanNodeId node = view_->selected();
    if (!from_text_)
        text_->showPlace(node.valid() ? view_->tree()[node].at : posh::Spot());
}

void PlanPanel::showRunningLines() {
    std::set<int> lines;
    for (const PlanNodeId node : view_->states().running(view_->tree()))
        if (const auto line = view_->tree()[node].at.line; line > 0)
            lines.insert(static_cast<int>(line));
    text_->setRunningLines(lines);
}

void PlanPanel::showFinding() {
    finding_->setText(text_->wordsAtCursor());
    finding_->setVisible(!finding_->text().isEmpty());
}

void PlanPanel::search(const QString& words) {
    view_->find(words);
    showFound();
}

void PlanPanel::showFound() {
    const auto& found = view_->found();
    const bool any = !found.empty();
    previous_->setEnabled(any);
    next_->setEnabled(any);
    const auto at = std::ranges::find(found, view_->selected());
    found_->setVisible(!search_->text().trimmed().isEmpty());
    found_->setText(!any                ? tr("none")
                    : at == found.end() ? tr("%1 found").arg(found.size())
                                        : tr("%1 of %2").arg(at - found.begin() + 1).arg(found.size()));
}

void PlanPanel::showRunning() {
    const PlanTree& tree = view_->tree();
    std::vector<Row> rows;
    for (const PlanNodeId node : view_->states().running(tree))
        rows.push_back({QString(2 * tree[node].depth, u' ') + tree[node].name, node});
    const bool idle = rows.empty();
    running_title_->setText(idle ? tr("Nothing runs now") : tr("Running now"));
    side_->setTitleKept(running_, idle);
    fill(*running_, rows);
}

void PlanPanel::showReasons() {
    const PlanNodeId node = view_->selected();
    if (!node.valid())
        return showDriveRefusals();
    verdict_->setText(planVerdict(view_->tree(), view_->states(), node));
    showReasonRows(planReasons(view_->tree(), view_->states(), node));
}

void PlanPanel::showDriveRefusals() {
    const auto refusals = driveRefusals(view_->tree(), view_->states());
    verdict_->setText(refusals.empty() ? tr("Why?") : tr("What prevents the drives that do not run:"));
    if (!refusals.empty())
        return showReasonRows(refusals);
    fill(*reasons_,
         {{view_->tree().empty() ? QString() : tr("Select a part of the plan to see why it runs or does not run.")}});
}

void PlanPanel::showReasonRows(const std::vector<PlanReason>& reasons) {
    std::vector<Row> rows;
    for (const PlanReason& reason : reasons)
        rows.push_back({reason.text, reason.node, verdictIcon(reason.verdict), 1 + static_cast<int>(reason.verdict),
                        reason.since});
    fill(*reasons_, rows);
}

void PlanPanel::jumpTo(const QListWidgetItem* item) {
    if (const PlanNodeId node{item->data(node_role).toInt()}; node.valid())
        view_->select(node);
}

void PlanPanel::activate(const QListWidgetItem* item) {
    const auto since = sinceOf(item); // The selection may change the rows.
    jumpTo(item);
    askForTime(since);
}

void PlanPanel::askForTime(const std::optional<Seconds>& time) {
    if (time)
        emit time_bar_->timeWanted(*time);
}

/// The first click of a double-click selects, which may put another reason under the mouse, or none. So the time is
/// that of the reason that was there before.
bool PlanPanel::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (watched != reasons_->viewport())
        return QWidget::eventFilter(watched, event);
    if (type == QEvent::MouseButtonPress)
        pressed_since_ = sinceOf(reasons_->itemAt(static_cast<QMouseEvent*>(event)->position().toPoint()));
    else if (type == QEvent::MouseButtonRelease)
        return std::exchange(double_clicked_, false);
    if (type != QEvent::MouseButtonDblClick || static_cast<QMouseEvent*>(event)->button() != Qt::LeftButton)
        return QWidget::eventFilter(watched, event);
    double_clicked_ = true;
    askForTime(pressed_since_);
    return true;
}

/// Switches between the narrow and the wide layout.
void PlanPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const int narrow = width() < narrow_panel_px ? 1 : 0;
    if (narrow == narrow_)
        return;
    narrow_ = narrow;
    head_->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    body_->setOrientation(narrow ? Qt::Vertical : Qt::Horizontal);
    body_->setSizes(narrow ? QList<int>{height() / 3, height() * 2 / 3, height() / 3}
                           : QList<int>{width() / 3, width() - 280, 280});
}

/// The window may use the same key for something else; inside the panel it starts the panel's search.
bool PlanPanel::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Find)) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void PlanPanel::keyPressEvent(QKeyEvent* event) {
    if (!event->matches(QKeySequence::Find))
        return QWidget::keyPressEvent(event);
    search_->setFocus(Qt::ShortcutFocusReason);
    search_->selectAll();
}

} // namespace usar::widgets
