// Outputs appear whole or not at all.

#include "common/output_file.h"

#include <cerrno>
#include <csignal>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/interrupt.h"
#include "tests/files/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace eikonal::test {
namespace {

TEST(OutputFile, AppearsOnCommitOnly) {
    const TemporaryFolder folder;
    {
        OutputFile output(folder / "a.txt");
        writeText(output.path(), "new");
        EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
        EXPECT_EQ(output.path().extension(), ".txt");
        output.commit();
    }
    EXPECT_EQ(readText(folder / "a.txt"), "new");
    EXPECT_EQ(folder.names().size(), 1u);
}

TEST(OutputFile, LeavesTheOldFileWithoutCommit) {
    const TemporaryFolder folder;
    writeText(folder / "a.txt", "old");
    {
        OutputFile output(folder / "a.txt");
        writeText(output.path(), "half of the ne");
    }
    EXPECT_EQ(readText(folder / "a.txt"), "old");
    EXPECT_EQ(folder.names().size(), 1u);
}

TEST(OutputFile, FollowsLinksAndKeepsThem) {
    const TemporaryFolder folder;
    writeText(folder / "real.txt", "old");
    std::filesystem::create_symlink("real.txt", folder / "link.txt");
    writeFile(folder / "link.txt", "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
    EXPECT_EQ(readText(folder / "real.txt"), "new");
}

TEST(OutputFile, NamesTheFolderThatIsMissing) {
    const TemporaryFolder folder;
    expectError(ExitCode::kFailure, "no folder", [&] { requireWritable(folder / "missing" / "a.txt"); });
    expectError(ExitCode::kFailure, "found a folder", [&] { requireWritable(folder.path()); });
}

TEST(OutputFile, RefusesAnUnwritableFolder) {
    if (geteuid() == 0)
        GTEST_SKIP() << "root may write everywhere";
    const TemporaryFolder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    expectError(ExitCode::kFailure, "a.txt", [&] { requireWritable(folder / "a.txt"); });
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
}

TEST(OutputFile, ReportsAFullDisk) {
    struct stat status = {};
    if (stat("/dev/full", &status) != 0)
        GTEST_SKIP() << "there is no /dev/full";
    expectError(ExitCode::kFailure, "/dev/full", [] { writeFile("/dev/full", "text"); });
    EXPECT_EQ(stat("/dev/full", &status), 0);
    EXPECT_TRUE(S_ISCHR(status.st_mode)) << "a device must not be replaced";
}

/// Forks a child that holds an unfinished output and waits for signals; returns its exit status.
int signalTwice(const std::filesystem::path& target, int signal) {
    int ready[2];
    EXPECT_EQ(pipe(ready), 0);
    const pid_t child = fork();
    if (child == 0) {
        installInterruptHandlers();
        OutputFile output(target);
        (void)!write(ready[1], "x", 1);
        for (;;)
            pause();
    }
    char byte = 0;
    EXPECT_EQ(read(ready[0], &byte, 1), 1);
    kill(child, signal);
    for (int tries = 0; tries < 200 && waitpid(child, nullptr, WNOHANG) == 0; ++tries) {
        usleep(20'000);
        if (kill(child, signal) != 0)
            break;
    }
    int status = 0;
    waitpid(child, &status, 0);
    close(ready[0]);
    close(ready[1]);
    return status;
}

TEST(Interrupt, TheSecondSignalRemovesWhatIsUnfinished) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const TemporaryFolder folder;
        signalTwice(folder / "a.txt", signal);
        EXPECT_EQ(folder.names().size(), 0u);
    }
}

TEST(Interrupt, TheFirstSignalRaisesTheFlag) {
    const pid_t child = fork();
    if (child == 0) {
        installInterruptHandlers();
        const bool before = interrupted();
        raise(SIGINT);
        bool threw = false;
        try {
            throwIfInterrupted();
        } catch (const Error& error) {
            threw = error.code() == ExitCode::kFailure;
        }
        _exit(!before && interrupted() && threw ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

} // namespace
} // namespace eikonal::test
