#include "widgets/plan/editor/plan_palette.h"

#include <algorithm>

#include <QMimeData>

#include "core/posh/model/literal.h"
#include "widgets/plan/plan_parts.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

namespace {

constexpr int help_role = Qt::UserRole;
constexpr int words_role = Qt::UserRole + 1;
constexpr int sense_role = Qt::UserRole + 2;
constexpr std::size_t first_form_group = 2; ///< the groups from here on are in the order of posh::Form

QString answerWord(agent::AnswerType type) {
    constexpr std::array words{"anything", "true or false", "a whole number", "a number", "a text", "a symbol"};
    return QObject::tr(words[static_cast<std::size_t>(type)]); // In the order of the types.
}

/// Describes a sense or act in sentences, one per line: help, type and unit of the answer, parameters, requirements.
QString helpText(const agent::PrimitiveDescription& primitive) {
    QStringList lines{QString::fromStdString(primitive.help)};
    if (primitive.kind == agent::PrimitiveKind::Sense)
        lines << (primitive.unit.empty()
                      ? QObject::tr("Answers with %1.").arg(answerWord(primitive.answer))
                      : QObject::tr("Answers with %1 in %2.")
                            .arg(answerWord(primitive.answer), QString::fromStdString(primitive.unit)));
    for (const agent::PoshParameter& parameter : primitive.parameters)
        lines << QStringLiteral("$%1=%2: %3%4")
                     .arg(QString::fromStdString(parameter.name),
                          QString::fromStdString(posh::spelled(parameter.default_value)),
                          QString::fromStdString(agent::typeText(parameter)),
                          parameter.help.empty() ? QString()
                                                 : QStringLiteral(". ") + QString::fromStdString(parameter.help));
    if (!primitive.needs.empty()) {
        QStringList needs;
        for (const std::string& need : primitive.needs)
            needs << QString::fromStdString(need);
        lines << QObject::tr("Needs %1.").arg(needs.join(QStringLiteral(", ")));
    }
    lines.removeAll(QString());
    return lines.join(u'\n');
}

/// Returns the initial test of a sense in a plan: numbers are compared with 0, everything else is tested without a
/// comparison.
QString firstTest(const agent::PrimitiveDescription& sense) {
    const QString name = QString::fromStdString(sense.name);
    return sense.answer == agent::AnswerType::Integer ? name + QStringLiteral(" 0 >")
           : sense.answer == agent::AnswerType::Real  ? name + QStringLiteral(" 0.0 >")
                                                      : name;
}

/// A list whose items can be dragged as pieces.
class PieceList : public QTreeWidget {
public:
    explicit PieceList(QWidget* parent) : QTreeWidget(parent) {
        setHeaderHidden(true);
        setRootIsDecorated(true);
        setIndentation(14);
        setDragEnabled(true);
        setDragDropMode(QAbstractItemView::DragOnly);
        setUniformRowHeights(true);
        setIconSize({14, 14});
        setMinimumHeight(80);
    }

protected:
    QStringList mimeTypes() const override { return {QString::fromLatin1(plan_piece_mime_type)}; }
    QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override {
        return items.isEmpty()
                   ? nullptr
                   : mimeOf({items[0]->data(0, sense_role).toBool(), items[0]->data(0, words_role).toString()});
    }
};

} // namespace

QMimeData* mimeOf(const PlanPiece& piece) {
    auto* data = new QMimeData;
    data->setData(QString::fromLatin1(plan_piece_mime_type),
                  (piece.is_sense ? QStringLiteral("sense ") : QStringLiteral("act ")).toUtf8() + piece.words.toUtf8());
    data->setText(piece.is_sense ? u'(' + piece.words + u')' : piece.words); // For a drop into any text.
    return data;
}

std::optional<PlanPiece> pieceOf(const QMimeData& data) {
    const QString text = QString::fromUtf8(data.data(QString::fromLatin1(plan_piece_mime_type)));
    const QString kind = text.section(u' ', 0, 0);
    if (kind != u"sense" && kind != u"act")
        return std::nullopt;
    return PlanPiece{kind == u"sense", text.section(u' ', 1)};
}

PlanPalette::PlanPalette(QWidget* parent)
    : QWidget(parent)
    , search_(makeSearchLine(tr("Find a piece"), tr("Names and descriptions; Return goes to the list"), this))
    , list_(new PieceList(this))
    , help_(makeLabel(this, "muted")) {
    setAccessibleName(tr("Pieces"));
    named(list_, tr("Senses, acts and forms"),
          tr("Drag a piece into the drawing; Return or a double-click adds it at the selected part"));
    help_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    help_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    help_->setMinimumHeight(3 * help_->fontMetrics().height());
    laidOut(new QVBoxLayout(this), {}, gap::tiny, {search_, list_, help_})->setStretchFactor(list_, 1);
    connect(search_, &QLineEdit::textChanged, this, &PlanPalette::applyFilter);
    connect(search_, &QLineEdit::returnPressed, this, [this] { list_->setFocus(Qt::OtherFocusReason); });
    connect(list_, &QTreeWidget::currentItemChanged, this, &PlanPalette::explain);
    connect(list_, &QTreeWidget::itemActivated, this, [this] {
        if (const auto piece = chosen())
            emit pieceRequested(*piece);
    });
    setPrimitives({});
}

void PlanPalette::setPrimitives(const std::vector<agent::PrimitiveDescription>& primitives) {
    auto& senses = groups_[0];
    auto& acts = groups_[1];
    senses.clear();
    acts.clear();
    for (const agent::PrimitiveDescription& primitive : primitives) {
        const bool is_sense = primitive.kind == agent::PrimitiveKind::Sense;
        const QString name = QString::fromStdString(primitive.name);
        (is_sense ? senses : acts)
            .push_back({name, helpText(primitive), {is_sense, is_sense ? firstTest(primitive) : name}});
    }
    senses.push_back({"succeed", tr("Always holds. Every robot has it."), {true, "succeed"}});
    senses.push_back({"fail", tr("Never holds. Every robot has it."), {true, "fail"}});
    acts.push_back({"doNothing", tr("Does nothing, once. Every robot has it."), {false, "doNothing"}});
    rebuild();
}

void PlanPalette::setPlan(const posh::Plan& plan) {
    const std::array help{tr("A competence of this plan."), tr("An action pattern of this plan."),
                          tr("An adopt of this plan.")};
    auto groups = groups_;
    for (std::size_t i = first_form_group; i < groups.size(); ++i)
        groups[i].clear();
    for (const posh::Form& form : plan.forms) {
        const QString name = QString::fromStdString(posh::nameOf(form).text);
        if (!std::holds_alternative<posh::Collection>(form))
            groups[first_form_group + form.index()].push_back({name, help[form.index()], {false, name}});
    }
    if (groups == groups_)
        return;
    groups_ = std::move(groups);
    rebuild();
}

void PlanPalette::rebuild() {
    const auto before = chosen();
    list_->clear();
    const std::array titles{tr("Senses"), tr("Acts"), tr("Competences"), tr("Action patterns"), tr("Adopts")};
    constexpr std::array icons{"eye", "play", "branches", "step", "reset"};
    QFont font = list_->font();
    font.setWeight(QFont::DemiBold);
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        if (i >= first_form_group && groups_[i].empty())
            continue;
        auto* head = new QTreeWidgetItem(list_, {titles[i]});
        head->setFlags(Qt::ItemIsEnabled);
        head->setFont(0, font);
        for (const Entry& entry : groups_[i]) {
            auto* item = new QTreeWidgetItem(head, {entry.name});
            item->setData(0, help_role, entry.help);
            item->setData(0, words_role, entry.piece.words);
            item->setData(0, sense_role, entry.piece.is_sense);
            item->setIcon(0, icon(QString::fromLatin1(icons[i])));
            item->setToolTip(0, entry.help);
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled);
        }
        head->setExpanded(true);
    }
    applyFilter();
    for (QTreeWidgetItemIterator item(list_); before && *item; ++item)
        if ((*item)->data(0, words_role).toString() == before->words)
            list_->setCurrentItem(*item);
    explain();
    emit wordsChanged();
}

std::vector<PlanWord> PlanPalette::words() const {
    std::vector<PlanWord> all;
    for (const std::vector<Entry>& entries : groups_)
        for (const Entry& entry : entries)
            all.push_back({entry.piece.is_sense, entry.name, entry.help.section(u'\n', 0, 0)});
    std::ranges::sort(all, [](const PlanWord& a, const PlanWord& b) {
        return QString::compare(a.name, b.name, Qt::CaseInsensitive) < 0;
    });
    return all;
}

void PlanPalette::applyFilter() {
    const QStringList words = search_->text().split(u' ', Qt::SkipEmptyParts);
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* const head = list_->topLevelItem(i);
        bool any = false;
        for (int j = 0; j < head->childCount(); ++j) {
            QTreeWidgetItem* const item = head->child(j);
            const QString text = item->text(0) + u' ' + item->data(0, help_role).toString();
            const bool fits = std::ranges::all_of(
                words, [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
            item->setHidden(!fits);
            any = any || fits;
        }
        head->setHidden(!any);
    }
}

std::optional<PlanPiece> PlanPalette::chosen() const {
    const QTreeWidgetItem* const item = list_->currentItem();
    if (!item || item->data(0, words_role).isNull())
        return std::nullopt;
    return PlanPiece{item->data(0, sense_role).toBool(), item->data(0, words_role).toString()};
}

void PlanPalette::explain() {
    const QTreeWidgetItem* const item = list_->currentItem();
    const QString help = item ? item->data(0, help_role).toString() : QString();
    help_->setText(help.isEmpty() ? tr("Drag pieces into the drawing.") : help);
}

} // namespace usar::widgets
