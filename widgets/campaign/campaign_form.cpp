#include "widgets/campaign/campaign_form.h"

#include <algorithm>

#include <QScrollBar>
#include <QThread>

#include "widgets/panels/quantity_box.h"
#include "widgets/style/scroll_box.h"
#include "widgets/style/theme.h"
#include "widgets/style/tips.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

namespace {

constexpr int most_seeds = 1'000'000;

template <class Box>
Box* field(Box* box, const QString& name, const QString& help) {
    box->setMinimumHeight(minimum_target);
    box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return named(box, name, help);
}

void setUpCount(QSpinBox* box, int least, int most, int value, const QString& name, const QString& help) {
    box->setRange(least, most);
    box->setValue(value);
    field(box, name, help);
    tellRange(box, help);
}

/// Lets a box be narrower than its longest entry, because docks are narrow.
void letShrink(QComboBox* box) {
    box->setMinimumContentsLength(8);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
}

} // namespace

CampaignForm::CampaignForm(QWidget* parent)
    : QWidget(parent)
    , share_(new QuantityBox(this))
    , browse_(makeToolButton(tr("Choose the folder for the results"), this, "open")) {
    auto* const fields = new QWidget;
    columns_ = laidOut(new QBoxLayout(QBoxLayout::TopToBottom, fields), {}, gap::tiny);
    for (QFormLayout** const column : {&what_, &where_}) {
        *column = new QFormLayout;
        (*column)->setHorizontalSpacing(gap::medium);
        (*column)->setVerticalSpacing(gap::tiny);
        (*column)->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
        auto* const box = new QVBoxLayout; // Its rows stay close together where the other column is taller.
        box->addLayout(*column);
        box->addStretch(1);
        columns_->addLayout(box, 1);
    }
    mission_->setAccessibleName(tr("Mission of the campaign"));
    what_->addRow(tr("Mission"), mission_);
    what_->addRow(own_);
    makeSeeds();
    makeBehaviors();
    makeParameter();
    makeFaults();
    makePlaces();
    alignLabels();
    makeButtons();
    auto* const scrolled = new QWidget;
    laidOut(new QVBoxLayout(scrolled), {}, gap::small, {trouble_, fields})->addStretch(1);
    scroll_ = new ScrollBox(scrolled);
    laidOut(new QVBoxLayout(this), {gap::small, gap::small, gap::small, gap::small}, gap::small, {scroll_, button_box_})
        ->setStretchFactor(scroll_, 1);
    connect(own_, &QPushButton::clicked, this, &CampaignForm::ownCampaignWanted);
    own_->setToolTip(tr("Closes the campaign's file and makes a campaign from the mission that is set up"));
    setParameters({});
    setFaultCount(0);
    setMission({}, {});
}

/// The fields of both columns begin at one line when they stand below each other.
void CampaignForm::alignLabels() {
    std::vector<QWidget*> labels;
    for (const QFormLayout* const column : {what_, where_})
        for (int row = 0; row < column->rowCount(); ++row)
            if (QLayoutItem* const item = column->itemAt(row, QFormLayout::LabelRole))
                labels.push_back(item->widget());
    int widest_px = 0;
    for (const QWidget* const label : labels)
        widest_px = std::max(widest_px, label->sizeHint().width());
    for (QWidget* const label : labels)
        label->setMinimumWidth(widest_px);
}

/// They are outside of what scrolls, so that they are always seen.
void CampaignForm::makeButtons() {
    trouble_->setWordWrap(true);
    trouble_->setAccessibleName(tr("What is wrong with the campaign"));
    setRole(trouble_, "caution");
    trouble_->hide();
    run_->setProperty("role", "primary");
    buttons_ = gridOf(button_box_, {}, gap::small, gap::tiny);
    placeButtons(false);
}

void CampaignForm::placeButtons(bool wide) {
    buttons_->addWidget(run_, 0, 0, 1, wide ? 1 : 3);
    for (int column = wide ? 1 : 0; QPushButton* const button : {open_, open_folder_, save_})
        buttons_->addWidget(button, wide ? 0 : 1, column++);
}

void CampaignForm::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    constexpr int wide_px = 600;
    const bool wide = width() >= wide_px;
    columns_->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    columns_->setSpacing(wide ? gap::large : gap::tiny);
    placeButtons(wide);
}

void CampaignForm::makeSeeds() {
    setUpCount(first_seed_, 0, most_seeds, 1, tr("First seed"), tr("The seed of the first run"));
    setUpCount(seeds_, 1, most_seeds, 20, tr("Number of seeds"),
               tr("How many seeds are flown; every variant flies each of them"));
    first_seed_->setPrefix(tr("from "));
    seeds_->setSuffix(tr(" seeds"));
    for (QSpinBox* const box : {first_seed_, seeds_})
        box->setMinimumWidth(84); // They are that narrow only for numbers that hardly anybody types.
    laidOut(new QHBoxLayout(seed_row_), {}, gap::small, {first_seed_, seeds_});
    what_->addRow(tr("Seeds"), seed_row_);
    for (QSpinBox* const box : {first_seed_, seeds_})
        connect(box, &QSpinBox::valueChanged, this, &CampaignForm::changed);
}

void CampaignForm::makeBehaviors() {
    named(behaviors_, tr("Behaviors that are compared"),
          tr("Each checked behavior flies every seed; the first one is what the others are compared with"));
    behaviors_->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    behaviors_->setUniformItemSizes(true);
    behaviors_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    behaviors_->setTextElideMode(Qt::ElideRight);
    what_->addRow(tr("Behaviors"), behaviors_);
    connect(behaviors_, &QListWidget::itemChanged, this, &CampaignForm::changed);
}

void CampaignForm::makeParameter() {
    letShrink(field(parameter_, tr("Parameter that is varied"), tr("Its values are compared with each other")));
    field(values_, tr("Values of the parameter"), tr("Values that are compared, with commas: 3, 4.5, 6"));
    where_->addRow(tr("Vary"), parameter_);
    where_->addRow(tr("Values"), values_);
    connect(parameter_, &QComboBox::currentIndexChanged, this, [this](int index) {
        if (index > 0)
            values_->setPlaceholderText(
                tr("such as %1, …").arg(parameters_[static_cast<std::size_t>(index - 1)].usual));
        showFields();
        emit changed();
    });
    connect(values_, &QLineEdit::textChanged, this, &CampaignForm::changed);
}

void CampaignForm::makeFaults() {
    letShrink(field(faults_, tr("Faults"), tr("What goes wrong in the runs; all variants get the same on each seed")));
    faults_->addItems({tr("none"), QString(), tr("a swarm, drawn for each seed")});
    share_->setRange(0.01, 1.0);
    share_->setSingleStep(0.1);
    share_->setDecimals(2);
    share_->setValue(0.3);
    field(share_, tr("Share of the swarm"), {});
    tellRange(share_, tr("Each kind of fault is taken with this probability, then its time and strength are drawn"));
    where_->addRow(tr("Faults"), faults_);
    where_->addRow(tr("Share"), share_);
    connect(faults_, &QComboBox::currentIndexChanged, this, [this] {
        showFields();
        emit changed();
    });
    connect(share_, &QuantityBox::valueChanged, this, &CampaignForm::changed);
}

void CampaignForm::makePlaces() {
    const int processors = std::max(1, QThread::idealThreadCount());
    setUpCount(jobs_, 1, 4 * processors, std::max(1, processors - 1), tr("Missions at a time"),
               tr("Each takes a processor; the robots in this window need one, too"));
    field(folder_, tr("Folder for the results"),
          tr("The results are kept here; a folder that holds a part of them already is gone on with"));
    auto* const row = new QWidget;
    laidOut(new QHBoxLayout(row), {}, gap::tiny, {folder_, browse_});
    where_->addRow(tr("At a time"), jobs_);
    where_->addRow(tr("Folder"), row);
    connect(jobs_, &QSpinBox::valueChanged, this, &CampaignForm::changed);
    connect(folder_, &QLineEdit::textChanged, this, &CampaignForm::changed);
    connect(browse_, &QToolButton::clicked, this, &CampaignForm::folderWanted);
}

void CampaignForm::setMission(const QString& mission, const QString& trouble) {
    mission_trouble_ = trouble;
    mission_->setText(!file_.isEmpty() ? file_ : trouble.isEmpty() ? mission : tr("none is set up"));
    mission_->setToolTip(mission_->text());
    showFields();
    showTrouble();
}

void CampaignForm::setFile(const QString& words) {
    file_ = words;
    setMission(mission_->text(), mission_trouble_);
}

/// Hides what has no meaning now.
void CampaignForm::showFields() {
    const bool own = file_.isEmpty();
    what_->setRowVisible(own_, !own);
    what_->setRowVisible(seed_row_, own);
    what_->setRowVisible(behaviors_, own && behaviors_->count() > 0);
    where_->setRowVisible(parameter_, own);
    where_->setRowVisible(faults_, own);
    where_->setRowVisible(values_, own && parameter_->currentIndex() > 0);
    where_->setRowVisible(share_, own && faults_->currentIndex() == static_cast<int>(CampaignFaults::Swarm));
}

void CampaignForm::setBehaviors(const std::vector<CampaignBehavior>& behaviors, const QString& usual) {
    if (behaviors == known_behaviors_)
        return; // The list may have the focus.
    known_behaviors_ = behaviors;
    const QStringList checked = wish().behaviors;
    const bool any = std::ranges::any_of(behaviors, [&](const auto& one) { return checked.contains(one.id); });
    const QSignalBlocker quiet(behaviors_);
    behaviors_->clear();
    for (const CampaignBehavior& one : behaviors) {
        auto* const item = new QListWidgetItem(one.name, behaviors_);
        item->setData(Qt::UserRole, one.id);
        item->setToolTip(one.id);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
        item->setCheckState((any ? checked.contains(one.id) : one.id == usual) ? Qt::Checked : Qt::Unchecked);
    }
    const int rows = std::clamp(static_cast<int>(behaviors.size()), 1, 4);
    const int row_px = std::max(1, behaviors_->sizeHintForRow(0));
    behaviors_->setFixedHeight(rows * row_px + 2 * behaviors_->frameWidth());
    showFields();
}

void CampaignForm::setParameters(const std::vector<CampaignParameter>& parameters) {
    if (parameters == parameters_ && parameter_->count() > 0)
        return;
    const QString chosen = wish().parameter;
    parameters_ = parameters;
    const QSignalBlocker quiet(parameter_);
    parameter_->clear();
    parameter_->addItem(tr("no parameter"));
    for (const CampaignParameter& one : parameters)
        parameter_->addItem(one.unit.isEmpty() ? one.label : one.label + " [" + one.unit + ']', one.id);
    parameter_->setCurrentIndex(std::max(0, parameter_->findData(chosen)));
    showFields();
}

void CampaignForm::setFaultCount(int count) {
    faults_->setItemText(static_cast<int>(CampaignFaults::OfTheDock), tr("those in the dock Faults (%1)").arg(count));
}

void CampaignForm::setFolder(const QString& folder) {
    if (folder_->text() != folder)
        folder_->setText(folder);
}

void CampaignForm::setTrouble(const QString& trouble) {
    field_trouble_ = trouble;
    showTrouble();
}

void CampaignForm::showTrouble() {
    const QString text = !field_trouble_.isEmpty() || !file_.isEmpty() ? field_trouble_ : mission_trouble_;
    if (trouble_->text() == text)
        return;
    trouble_->setText(text);
    trouble_->setVisible(!text.isEmpty());
    scroll_->verticalScrollBar()->setValue(0); // It stands at the top.
}

void CampaignForm::setActions(QAction* run, QAction* save, QAction* open, QAction* open_folder) {
    followAction(run_, run);
    followAction(save_, save);
    followAction(open_, open);
    followAction(open_folder_, open_folder);
}

CampaignWish CampaignForm::wish() const {
    CampaignWish wish;
    wish.first_seed = first_seed_->value();
    wish.seeds = seeds_->value();
    for (int i = 0; i < behaviors_->count(); ++i)
        if (behaviors_->item(i)->checkState() == Qt::Checked)
            wish.behaviors << behaviors_->item(i)->data(Qt::UserRole).toString();
    wish.parameter = parameter_->currentData().toString();
    wish.values = values_->text();
    wish.faults = static_cast<CampaignFaults>(std::max(0, faults_->currentIndex()));
    wish.swarm_share = share_->value();
    wish.jobs = jobs_->value();
    wish.folder = folder_->text().trimmed();
    return wish;
}

} // namespace usar::widgets
