#include "widgets/plan/plan_panel.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <QApplication>
#include <QKeyEvent>
#include <QResizeEvent>
#include <QScopedValueRollback>
#include <QShortcut>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "core/posh/language/plan_reader.h"
#include "widgets/models/plan/plan_places.h"
#include "widgets/models/plan/plan_reasons.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

namespace {

constexpr int narrow_panel_px = 640;
constexpr int node_role = Qt::UserRole;
constexpr int breakpoint_role = Qt::UserRole + 2; // On items of the breakpoint list: its id.

struct Row {
    QString text;
    int node = -1;
    QIcon icon{};
    int mark = 0; ///< rows with different marks differ even if their text is the same
};

/// Changes only the rows that differ, so that neither selection nor scroll position jumps at every tick.
void fill(QListWidget& list, const std::vector<Row>& rows) {
    const int count = static_cast<int>(rows.size());
    while (list.count() > count)
        delete list.takeItem(list.count() - 1);
    for (int i = 0; i < count; ++i) {
        const Row& row = rows[static_cast<std::size_t>(i)];
        if (i == list.count())
            list.addItem(new QListWidgetItem);
        QListWidgetItem* const item = list.item(i);
        if (item->text() != row.text)
            item->setText(row.text);
        if (item->data(node_role).isNull() || item->data(node_role + 1).toInt() != row.mark)
            item->setIcon(row.icon);
        item->setData(node_role, row.node);
        item->setData(node_role + 1, row.mark);
    }
}

QIcon verdictIcon(PlanVerdict verdict) {
    switch (verdict) {
    case PlanVerdict::Yes:
        return icon(QStringLiteral("check"), tokens().ok);
    case PlanVerdict::No:
        return icon(QStringLiteral("clear"), tokens().danger);
    case PlanVerdict::Open:
        break;
    }
    return icon(QStringLiteral("help"), tokens().text_muted);
}

QLabel* makeTitle(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setProperty("role", "title");
    label->setWordWrap(true);
    return label;
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
    head_->setSpacing(gap::tiny);
    head_->addLayout(makeSearchRow(), 1);
    head_->addLayout(makeButtonRow());
    side_ = new SectionStack(tr("Lists of the plan"), this);
    fillSide();
    body_->addWidget(makeText());
    body_->addWidget(view_);
    body_->addWidget(side_);
    body_->setStretchFactor(1, 1);
    body_->setHandleWidth(gap::small);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(gap::small, gap::small, gap::small, gap::small);
    column->setSpacing(gap::tiny);
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
        if (view_->selected() >= 0 && !side_->isAncestorOf(QApplication::focusWidget()))
            side_->show(reasons_);
    });
    connect(view_, &PlanView::selectionChanged, this, &PlanPanel::showFound);
    connect(view_, &PlanView::treeChanged, this, &PlanPanel::showTree);
    connect(view_, &PlanView::refreshed, this, &PlanPanel::showRunningLines);
    connect(view_, &PlanView::selectionChanged, this, &PlanPanel::showTextPlace);
    connect(view_, &PlanView::activated, this, [this](int node) {
        if (text_shown_->isEnabled())
            text_shown_->setChecked(true);
        emit textRequested(view_->tree()[node].at);
    });
    side_->hide();
    time_bar_->hide();
    showFound();
    showRunning();
    showReasons();
}

void PlanPanel::showTree() {
    const bool empty = view_->tree().empty();
    if (empty && time_bar_->slider()->hasFocus()) { // or the search would have the keys until a plan comes
        slider_waits_ = true;
        view_->setFocus();
    }
    side_->setVisible(!empty);
    time_bar_->setVisible(!empty);
    if (!empty && std::exchange(slider_waits_, false) && view_->hasFocus()) {
        QSlider* const slider = time_bar_->slider();
        slider->setEnabled(true); // it may not know the plan's moments yet, and a disabled one takes no focus
        slider->setFocus();
    }
    showRunning();
    search(search_->text());
}

QBoxLayout* PlanPanel::makeSearchRow() {
    auto* row = new QHBoxLayout;
    row->setSpacing(gap::tiny);
    search_ = makeSearchLine(tr("Find in the plan"),
                             tr("Names or kinds (drive, competence, element, act, sense, …); Return goes to the next, "
                                "Shift+Return to the previous (Ctrl+F)"),
                             this);
    row->addWidget(search_, 1);
    found_ = new QLabel(this);
    found_->setProperty("role", "muted");
    row->addWidget(found_);
    previous_ = addButton(row, QStringLiteral("up"), tr("Previous one found (Shift+Return)"));
    next_ = addButton(row, QStringLiteral("down"), tr("Next one found (Return)"));
    connect(previous_, &QToolButton::clicked, this, [this] { view_->findNext(true); });
    connect(next_, &QToolButton::clicked, this, [this] { view_->findNext(); });
    connect(search_, &QLineEdit::textChanged, this, &PlanPanel::search);
    auto* next = new QShortcut(Qt::Key_Return, search_, nullptr, nullptr, Qt::WidgetShortcut);
    auto* previous = new QShortcut(Qt::SHIFT | Qt::Key_Return, search_, nullptr, nullptr, Qt::WidgetShortcut);
    auto* done = new QShortcut(Qt::Key_Escape, search_, nullptr, nullptr, Qt::WidgetShortcut);
    connect(next, &QShortcut::activated, this, [this] { view_->findNext(); });
    connect(previous, &QShortcut::activated, this, [this] { view_->findNext(true); });
    connect(done, &QShortcut::activated, this, [this] {
        search_->clear();
        view_->setFocus(Qt::OtherFocusReason);
    });
    return row;
}

QToolButton* PlanPanel::addButton(QBoxLayout* row, const QString& icon_name, const QString& help) {
    auto* button = makeToolButton(help, this, icon_name);
    row->addWidget(button);
    return button;
}

QBoxLayout* PlanPanel::makeButtonRow() {
    auto* row = new QHBoxLayout;
    row->setSpacing(gap::tiny);
    text_shown_ = addButton(row, QStringLiteral("text"), tr("Shows the plan's text beside the drawing"));
    text_shown_->setCheckable(true);
    text_shown_->setEnabled(false);
    expanded_ = addButton(row, QStringLiteral("branches"),
                          tr("Draws parts that are used at several places at each of them; else once, with links"));
    expanded_->setCheckable(true);
    expanded_->setAccessibleName(tr("Shared parts everywhere"));
    connect(expanded_, &QToolButton::toggled, this, [this](bool expanded) {
        view_->setSharing(expanded ? PlanSharing::Expanded : PlanSharing::Once);
        view_->showBeginning();
    });
    auto* running = addButton(row, QStringLiteral("follow"), tr("Opens what runs now and folds the rest"));
    connect(running, &QToolButton::clicked, view_, &PlanView::showRunning);
    auto* unfold = addButton(row, QStringLiteral("unfold"), tr("Unfolds everything"));
    connect(unfold, &QToolButton::clicked, view_, &PlanView::unfoldAll);
    auto* fold = addButton(row, QStringLiteral("fold"), tr("Folds everything (Space folds the selected part)"));
    connect(fold, &QToolButton::clicked, view_, &PlanView::foldAll);
    auto* larger = addButton(row, QStringLiteral("plus"), tr("Larger (+, or the wheel)"));
    connect(larger, &QToolButton::clicked, view_, &PlanView::zoomIn);
    auto* smaller = addButton(row, QStringLiteral("minus"), tr("Smaller (-)"));
    connect(smaller, &QToolButton::clicked, view_, &PlanView::zoomOut);
    auto* fit = addButton(row, QStringLiteral("fit"), tr("Shows all of the plan (F)"));
    connect(fit, &QToolButton::clicked, view_, &PlanView::fit);
    auto* save = addButton(row, QStringLiteral("export"), tr("Saves the drawing as a picture"));
    connect(save, &QToolButton::clicked, this, &PlanPanel::exportRequested);
    row->addStretch(1);
    return row;
}

QWidget* PlanPanel::makeText() {
    auto* pane = new QWidget(this);
    auto* column = new QVBoxLayout(pane);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(gap::tiny);
    text_ = new PlanTextEdit(pane);
    finding_ = new QLabel(pane);
    finding_->setWordWrap(true);
    finding_->hide();
    column->addWidget(text_, 1);
    column->addWidget(finding_);
    pane->hide();
    connect(text_shown_, &QToolButton::toggled, pane, &QWidget::setVisible);
    connect(text_, &PlanTextEdit::placeEntered, this, [this](int line, int column_number) {
        const QScopedValueRollback from_text(from_text_, true);
        if (const int node = nodeAtPlace(view_->tree(), line, column_number); node >= 0)
            view_->select(node);
        showFinding();
    });
    return pane;
}

void PlanPanel::fillSide() {
    running_title_ = makeTitle(tr("Running now"), side_);
    running_ = makeList(tr("Running now"), tr("What runs now, from the root on; a click goes there"));
    side_->add(running_title_, running_, tr("Running"), 2);
    verdict_ = makeTitle({}, side_);
    reasons_ = makeList(tr("Reasons"), tr("What lets the selected part run, and what does not; a click goes there"));
    reasons_->setWordWrap(true);
    side_->add(verdict_, reasons_, tr("Why?"), 3);
    side_->setTitleKept(reasons_, true); // It is the answer.
    addBoard();
    addBreakpointList();
}

/// Adds the list of values that the plan's acts have written; hidden while there are none.
void PlanPanel::addBoard() {
    board_ = makeList(tr("Blackboard"), {});
    side_->add(makeTitle(tr("Blackboard"), side_), board_, tr("Board"), 2);
    connect(board_, &QListWidget::currentRowChanged, this, &PlanPanel::keySelected);
    connect(board_, &QListWidget::itemActivated, this, &PlanPanel::keyActivated);
    showBoard();
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
        rows.push_back({one.key + " = " + one.value, -1,
                        is_watched ? icon(QStringLiteral("record"), tokens().danger) : QIcon(), is_watched ? 2 : 1});
    }
    fill(*board_, rows);
    for (int i = 0; i < board_->count(); ++i)
        board_->item(i)->setToolTip(board_values_[static_cast<std::size_t>(i)].history + '\n' +
                                    tr("A double-click stops the plan whenever this is written; once more: no more."));
}

void PlanPanel::addBreakpointList() {
    breakpoints_ = makeList(
        tr("Breakpoints"),
        tr("The tick switches one on and off, a click goes there, a double-click changes it, Delete takes it away"));
    side_->add(makeTitle(tr("Breakpoints"), side_), breakpoints_, tr("Breakpoints"), 2);
    connect(breakpoints_, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        emit breakpointSwitched(item->data(breakpoint_role).toInt(), item->checkState() == Qt::Checked);
    });
    connect(breakpoints_, &QListWidget::itemDoubleClicked, this,
            [this](const QListWidgetItem* item) { emit breakpointEditRequested(item->data(breakpoint_role).toInt()); });
    auto* away = new QShortcut(QKeySequence::Delete, breakpoints_, nullptr, nullptr, Qt::WidgetShortcut);
    connect(away, &QShortcut::activated, this, [this] {
        if (const QListWidgetItem* const item = breakpoints_->currentItem())
            emit breakpointRemoved(item->data(breakpoint_role).toInt());
    });
    setBreakpoints({});
}

void PlanPanel::setBreakpoints(const std::vector<BreakpointRow>& rows) {
    side_->setSectionShown(breakpoints_, !rows.empty());
    const QSignalBlocker quiet(breakpoints_);
    const int count = static_cast<int>(rows.size());
    while (breakpoints_->count() > count)
        delete breakpoints_->takeItem(breakpoints_->count() - 1);
    while (breakpoints_->count() < count) // Items are reused, because one of them may be emitting a signal.
        new QListWidgetItem(breakpoints_);
    for (int i = 0; i < count; ++i) {
        const BreakpointRow& row = rows[static_cast<std::size_t>(i)];
        QListWidgetItem* const item = breakpoints_->item(i);
        item->setText(row.text);
        item->setToolTip(row.help);
        item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
        item->setCheckState(row.enabled ? Qt::Checked : Qt::Unchecked);
        item->setData(node_role, row.path.empty() ? -1 : view_->tree().find(row.path));
        item->setData(breakpoint_role, row.id);
        item->setForeground(row.path.empty() ? tokens().stale : tokens().text);
    }
}

QListWidget* PlanPanel::makeList(const QString& name, const QString& help) {
    auto* list = new QListWidget(this);
    list->setAccessibleName(name);
    list->setToolTip(help);
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list->setMinimumHeight(24);
    list->setIconSize({14, 14});
    connect(list, &QListWidget::itemClicked, this, &PlanPanel::jumpTo);
    connect(list, &QListWidget::itemActivated, this, &PlanPanel::jumpTo);
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
    const int node = view_->selected();
    if (!from_text_)
        text_->showPlace(node < 0 ? posh::Spot() : view_->tree()[node].at);
}

void PlanPanel::showRunningLines() {
    std::set<int> lines;
    for (const int node : view_->states().running(view_->tree()))
        if (const auto line = view_->tree()[node].at.line; line > 0)
            lines.insert(static_cast<int>(line));
    text_->setRunningLines(lines);
}

/// Shows the finding in the cursor's line, else the number of findings.
void PlanPanel::showFinding() {
    const posh::Findings& all = text_->findings();
    const auto errors = std::count_if(all.begin(), all.end(), [](const posh::Finding& finding) {
        return severityOf(finding.code) == Severity::Error;
    });
    const auto warnings = std::ssize(all) - errors;
    const PlanNote* const note = text_->noteAtCursor();
    finding_->setVisible(!all.empty() || note);
    if (const posh::Finding* const finding = text_->findingAtCursor())
        finding_->setText(QString::fromStdString(posh::toText(*finding)));
    else if (note)
        finding_->setText(note->words);
    else
        finding_->setText(tr("Errors: %1, warnings: %2. F8 in the text goes to the next.").arg(errors).arg(warnings));
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
    const auto at = std::find(found.begin(), found.end(), view_->selected());
    found_->setVisible(!search_->text().trimmed().isEmpty());
    found_->setText(!any                ? tr("none")
                    : at == found.end() ? tr("%1 found").arg(found.size())
                                        : tr("%1 of %2").arg(at - found.begin() + 1).arg(found.size()));
}

void PlanPanel::showRunning() {
    const PlanTree& tree = view_->tree();
    std::vector<Row> rows;
    for (const int node : view_->states().running(tree))
        rows.push_back({QString(2 * tree[node].depth, u' ') + tree[node].name, node});
    const bool idle = rows.empty();
    running_title_->setText(idle ? tr("Nothing runs now") : tr("Running now"));
    side_->setTitleKept(running_, idle);
    fill(*running_, rows);
}

void PlanPanel::showReasons() {
    const int node = view_->selected();
    if (node < 0) {
        verdict_->setText(tr("Why?"));
        fill(*reasons_,
             {{view_->tree().empty() ? QString() : tr("Select a part of the plan to see why it runs, or why not.")}});
        return;
    }
    verdict_->setText(planVerdict(view_->tree(), view_->states(), node));
    std::vector<Row> rows;
    for (const PlanReason& reason : planReasons(view_->tree(), view_->states(), node))
        rows.push_back({reason.text, reason.node, verdictIcon(reason.verdict), 1 + static_cast<int>(reason.verdict)});
    fill(*reasons_, rows);
}

void PlanPanel::jumpTo(const QListWidgetItem* item) {
    if (const int node = item->data(node_role).toInt(); node >= 0)
        view_->select(node);
}

void PlanPanel::arrange() {
    const int narrow = width() < narrow_panel_px ? 1 : 0;
    if (narrow == narrow_)
        return;
    narrow_ = narrow;
    head_->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    body_->setOrientation(narrow ? Qt::Vertical : Qt::Horizontal);
    body_->setSizes(narrow ? QList<int>{height() / 3, height() * 2 / 3, height() / 3}
                           : QList<int>{width() / 3, width() - 280, 280});
}

void PlanPanel::resizeEvent(QResizeEvent* event) {
    arrange();
    QWidget::resizeEvent(event);
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

void PlanPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) { // Icons have the colors of the theme.
        reasons_->clear();
        showReasons();
    }
    QWidget::changeEvent(event);
}

} // namespace usar::widgets
