#include "widgets/plan/editor/plan_lists.h"

#include <algorithm>

#include "widgets/style/empty_state.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

QIcon warningIcon() {
    return icon(QStringLiteral("warning"), tokens().caution);
}

QIcon iconOf(posh::Code code) {
    return severityOf(code) == Severity::Error ? icon(QStringLiteral("error"), tokens().danger) : warningIcon();
}

QIcon iconOf(posh::ChangeKind kind) {
    using enum posh::ChangeKind;
    return kind == Added     ? icon(QStringLiteral("plus"), tokens().ok)
           : kind == Removed ? icon(QStringLiteral("minus"), tokens().danger)
           : kind == Moved   ? icon(QStringLiteral("unfold"), tokens().accent)
                             : icon(QStringLiteral("note"), tokens().caution);
}

void addRow(QListWidget& list, const QString& words, const posh::Spot& at, const QIcon& mark = {}) {
    auto* item = new QListWidgetItem(mark, words, &list);
    item->setData(Qt::UserRole, QVariantList{at.line, at.column, at.offset, at.length});
}

} // namespace

PlanLists::PlanLists(QWidget* parent) : QTabWidget(parent) {
    setDocumentMode(true);
    setMinimumHeight(64);
    findings_ = addList(tr("Problems"), tr("What is wrong with the plan; click to go there"), tr("No problems"),
                        tr("What is wrong is listed here while you type, with what to write instead."));
    differences_ = addList(tr("Differences"), tr("What has changed; click to go there"), tr("Nothing compared yet"),
                           tr("Use Compare, above, to list what has changed since another version."));
    usages_ = addList(tr("Usages"), tr("Where it is used; click to go there"), tr("No usages listed"),
                      tr("Select a part and press Shift+F12 to list all places that use it."));
}

QListWidget* PlanLists::addList(const QString& name, const QString& help, const QString& title, const QString& hint) {
    auto* list = named(new QListWidget(this), name, help);
    list->setWordWrap(true);
    list->setIconSize({14, 14});
    list->setFrameShape(QFrame::NoFrame);
    addTab(list, name);
    auto* const sheet = new EmptyState(list, title, hint);
    const auto show = [sheet, list] { sheet->setVisible(list->count() == 0); };
    connect(list->model(), &QAbstractItemModel::rowsInserted, sheet, show);
    connect(list->model(), &QAbstractItemModel::rowsRemoved, sheet, show);
    connect(list->model(), &QAbstractItemModel::modelReset, sheet, show);
    const auto go = [this](const QListWidgetItem* item) {
        const QVariantList place = item->data(Qt::UserRole).toList();
        if (place.size() == 4 && place[0].toUInt() > 0)
            emit placeChosen({place[0].toUInt(), place[1].toUInt(), place[2].toUInt(), place[3].toUInt()});
    };
    connect(list, &QListWidget::itemClicked, this, go);
    connect(list, &QListWidget::itemActivated, this, go);
    return list;
}

void PlanLists::showFindings(const posh::Findings& findings, const std::vector<PlanNote>& notes) {
    const int row = findings_->currentRow();
    findings_->clear();
    for (const posh::Finding& finding : findings)
        addRow(*findings_, QString::fromStdString(posh::toText(finding)), finding.at, iconOf(finding.code));
    for (const PlanNote& note : notes)
        addRow(*findings_, note.words, note.at, icon(QStringLiteral("note"), tokens().accent));
    findings_->setCurrentRow(std::min(row, findings_->count() - 1));
    const int count = findings_->count();
    setTabText(0, count == 0 ? tr("Problems") : tr("Problems (%1)").arg(count));
}

void PlanLists::showDifferences(const std::vector<posh::PlanChange>& changes, bool is_partial) {
    differences_->clear();
    for (const posh::PlanChange& change : changes)
        addRow(*differences_, QString::fromStdString(change.line), change.after_at, iconOf(change.kind));
    if (changes.empty())
        addRow(*differences_, tr("No difference except in layout and comments"), {});
    if (is_partial)
        addRow(*differences_, tr("Parts that cannot be read are left out"), {}, warningIcon());
    setTabText(1, tr("Differences (%1)").arg(changes.size()));
    setCurrentWidget(differences_);
}

void PlanLists::showUsages(const posh::Plan& plan, const posh::PlanPart& part) {
    usages_->clear();
    for (const posh::PlanPart& usage : posh::usagesOf(plan, part)) {
        const posh::Spot& at = posh::nameOf(plan, usage)->at;
        const std::string words = usage.kind == posh::PartKind::Whole
                                      ? posh::describe(plan, usage)
                                      : "in " + posh::describe(plan, posh::ownerOf(usage));
        addRow(*usages_, tr("Line %1: %2").arg(at.line).arg(QString::fromStdString(words)), at);
    }
    setTabText(2, tr("Usages (%1)").arg(usages_->count()));
    setCurrentWidget(usages_);
}

void PlanLists::showLosses(const std::vector<posh::Loss>& losses) {
    usages_->clear();
    for (const posh::Loss& loss : losses)
        addRow(*usages_, QString::fromStdString(loss.message), loss.at, warningIcon());
    setTabText(2, tr("Lost in the export (%1)").arg(losses.size()));
    if (!losses.empty())
        setCurrentWidget(usages_);
}

} // namespace usar::widgets
