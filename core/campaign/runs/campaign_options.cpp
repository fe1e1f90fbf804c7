#include "core/campaign/runs/campaign_options.h"

#include "core/base/numbers.h"
#include "core/mission/files/command_line.h"

namespace usar::campaign {

namespace {

const std::string how =
    "Write usar-mission campaign CAMPAIGN.json --out DIR, or usar-mission campaign --tests FOLDER; --help tells more";

constexpr int most_runs = 10'000'000;

/// A whole number of the text, between the two; nullopt otherwise.
std::optional<int> wholeNumber(const QString& text, int least, int most) {
    const auto number = readInteger(text.toStdString());
    return number && *number >= least && *number <= most ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

Result<Shard> readShard(const QCommandLineParser& parser) {
    const QStringList parts = parser.value("shard").split('/');
    const auto of = wholeNumber(parts.value(1), 1, most_shards);
    const auto index = wholeNumber(parts.value(0), 0, of.value_or(1) - 1);
    if (parts.size() != 2 || !of || !index)
        return failure("this is no shard", mission::asWritten(parser, "shard"),
                       "Write I/N with N from 1 to " + std::to_string(most_shards) +
                           " and I from 0 to N - 1, for example --shard 0/4");
    return Shard{*index, *of};
}

/// Puts the option's value into `target`, if it is given.
template <class Target>
Result<void> readCount(const QCommandLineParser& parser, const QString& option, int least, int most, Target& target) {
    if (!parser.isSet(option))
        return {};
    const auto count = wholeNumber(parser.value(option), least, most);
    if (!count)
        return failure("this is no whole number from " + std::to_string(least) + " to " + std::to_string(most),
                       mission::asWritten(parser, option), ("For example --" + option + " 4").toStdString());
    target = *count;
    return {};
}

/// Reads what is flown, and where the results go.
Result<void> readSubject(const QCommandLineParser& parser, const QStringList& arguments, CampaignOptions& options) {
    const QStringList words = parser.positionalArguments();
    options.tests = parser.value("tests");
    options.junit = parser.value("junit");
    options.folder = parser.value("out");
    const bool are_tests = parser.isSet("tests");
    if (words.size() != (are_tests ? 0 : 1) || (are_tests && options.tests.isEmpty()))
        return failure("this is not how to call it", arguments.join(' ').toStdString(), how);
    if (!are_tests && options.folder.isEmpty())
        return failure("--out is missing", arguments.join(' ').toStdString(), how);
    if (!are_tests && parser.isSet("junit"))
        return failure("a campaign that is no folder of tests has no such report yet", "--junit",
                       "Fly it, then write usar-mission compare DIR --junit FILE");
    if (!are_tests)
        options.file = words.first();
    if (are_tests && parser.isSet("resume") && options.folder.isEmpty())
        return failure("there are no results to go on with", "--resume", "Name their folder with --out");
    for (const char* const whole : {"slurm", "shard", "runs", "first-seed", "until-decided"})
        if (are_tests && parser.isSet(whole))
            return failure("tests are flown here, all of them, with their own seeds", std::string("--") + whole,
                           "Leave it out");
    return {};
}

QList<QCommandLineOption> optionList() {
    return {{"out", "where the results go; tests need none", "DIR"},
            {"tests",
             "every mission in the folder is a test, flown with its own seed; its \"claims\" say what must hold",
             "FOLDER"},
            {"junit", "with --tests: write the results to this file as JUnit XML", "FILE"},
            {"jobs", "missions at a time (as many as there are processors)", "N"},
            {"resume", "go on with the results in DIR: only what is missing is flown"},
            {"shard",
             "only part I of N, from 0 to N - 1; for several machines that share DIR. It goes on where it was stopped",
             "I/N"},
            {"until-decided",
             "fly no more once it is known which of the two variants is better, by success and then by time; a test "
             "that may be looked at after each pair says so (95 %)"},
            {"check-every", "fly one run in N twice, which must come out the same (100; 0: none)", "N"},
            {"runs", "about N runs in all, with as many seeds as that takes instead of the file's", "N"},
            {"first-seed", "the first seed, instead of the file's", "N"},
            {"shrink",
             "of the runs that show a defect of the program (a crash, figures that cannot be, another result when "
             "flown again), add the fewest faults that still show it to FILE; a campaign file flies them again with "
             "\"again\": FILE",
             "FILE"},
            {"slurm", "fly nothing, but print a job script for sbatch, with so many parts", "TASKS"},
            usage::helpOption()};
}

} // namespace

Result<CampaignOptions> readCampaignOptions(const QStringList& arguments) {
    QCommandLineParser parser;
    const auto parsed = mission::parseArguments(parser, optionList(), arguments.mid(1), how);
    if (!parsed)
        return tl::unexpected(parsed.error());
    CampaignOptions options;
    if (auto read = readSubject(parser, arguments, options); !read)
        return tl::unexpected(read.error());
    options.resume = parser.isSet("resume");
    options.until_decided = parser.isSet("until-decided");
    if (options.until_decided && parser.isSet("shard"))
        return failure("a part of a campaign cannot decide it", "--until-decided --shard", "Leave out one of the two");
    if (auto read = readCount(parser, "jobs", 1, 1000, options.jobs); !read)
        return tl::unexpected(read.error());
    if (auto read = readCount(parser, "slurm", 1, most_shards, options.slurm); !read)
        return tl::unexpected(read.error());
    if (auto read = readCount(parser, "check-every", 0, 1'000'000, options.check_every); !read)
        return tl::unexpected(read.error());
    if (auto read = readCount(parser, "runs", 1, most_runs, options.runs); !read)
        return tl::unexpected(read.error());
    if (auto read = readCount(parser, "first-seed", 0, most_runs, options.first_seed); !read)
        return tl::unexpected(read.error());
    options.shrink = parser.value("shrink");
    if (options.slurm && !options.shrink.isEmpty())
        return failure("a job script does not shrink anything", "--slurm --shrink",
                       "Leave out one of the two, and give --shrink to a call with --resume when all is flown");
    if (options.slurm && parser.isSet("shard"))
        return failure("a job script divides the campaign by itself", "--slurm --shard", "Leave out one of the two");
    if (options.slurm && parser.isSet("until-decided"))
        return failure("the parts of a job script do not see each other's results, so none can tell when it is decided",
                       "--slurm --until-decided", "Leave out one of the two");
    if (parser.isSet("shard")) {
        const auto shard = readShard(parser);
        if (!shard)
            return tl::unexpected(shard.error());
        options.shard = *shard;
    }
    return options;
}

usage::Verb campaignVerb() {
    return {
        .name = "campaign",
        .calls = {"usar-mission campaign CAMPAIGN.json --out DIR [options]",
                  "usar-mission campaign --tests FOLDER [--junit FILE] [options]"},
        .purpose = "Flies the missions of a campaign, with all its seeds and variants, and writes one line for each.",
        .options = optionList(),
        .notes = {"A progress bar goes to standard error; the last line of standard output is one JSON object. Ctrl+C "
                  "keeps the results that are there."},
        .exit_codes = {{0, "all missions were done"},
                       {1, "some failed, or showed a defect of the program"},
                       {2, "bad use or input"}}};
}

} // namespace usar::campaign
