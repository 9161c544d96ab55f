// Untested. Expects what `./rubble install ThirdParty` makes, in the plugin's folder.
using System.IO;
using UnrealBuildTool;

public class Rubble : ModuleRules
{
    public Rubble(ReadOnlyTargetRules Target) : base(Target)
    {
        PCHUsage = PCHUsageMode.UseExplicitOrSharedPCHs;
        PublicDependencyModuleNames.Add("Core");
        string Root = Path.Combine(PluginDirectory, "ThirdParty");
        string Library = Path.Combine(Root, "lib", "librubble-physics.so.1");
        PublicSystemIncludePaths.Add(Path.Combine(Root, "include"));
        PublicAdditionalLibraries.Add(Path.Combine(Root, "lib", "librubble-physics.so"));
        RuntimeDependencies.Add("$(BinaryOutputDir)/librubble-physics.so.1", Library);
        PublicRuntimeLibraryPaths.Add(Path.Combine(Root, "lib"));
    }
}
