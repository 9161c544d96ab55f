// Untested. A world of Rubble in Unity: makes it, loads a level into it, steps it and breaks it. Offsets in the function table
// are those of tests/abi/layout.txt, which later versions keep.
using System;
using System.Runtime.InteropServices;
using UnityEngine;

public sealed class RubbleWorld : IDisposable
{
    const uint Version = 1, NoRenderer = 1;

    [StructLayout(LayoutKind.Sequential)]
    struct WorldSettings
    {
        public uint Size, Flags, PhysicsThreads, Reserved;
        public IntPtr User, Log, AssertionFailed, ParallelFor;
    }

    [StructLayout(LayoutKind.Sequential)]
    struct Explosion
    {
        public uint Size, Reserved;
        public double X, Y, Z, Metres, Impulse;
    }

    [DllImport("rubble-physics")] static extern int rubble_get_api(uint version, out IntPtr table);
    delegate IntPtr GetLastError();
    delegate int CreateWorld(ref WorldSettings settings, out ulong world);
    delegate int DestroyWorld(ulong world);
    delegate int LoadLevel(ulong world, [MarshalAs(UnmanagedType.LPUTF8Str)] string path, IntPtr vdbTool);
    delegate int Step(ulong world);
    delegate int Explode(ulong world, ref Explosion explosion);

    readonly IntPtr table;
    readonly ulong world;

    T Function<T>(int offset) where T : Delegate =>
        Marshal.GetDelegateForFunctionPointer<T>(Marshal.ReadIntPtr(table, offset));

    void Check(int result)
    {
        if (result != 0) throw new InvalidOperationException(Marshal.PtrToStringUTF8(Function<GetLastError>(8)()));
    }

    public RubbleWorld(string level)
    {
        var settings = new WorldSettings { Size = (uint)Marshal.SizeOf<WorldSettings>(), Flags = NoRenderer };
        if (rubble_get_api(Version, out table) != 0) throw new DllNotFoundException("librubble-physics has another version");
        Check(Function<CreateWorld>(24)(ref settings, out world));
        Check(Function<LoadLevel>(40)(world, level, IntPtr.Zero));
    }

    // From FixedUpdate, with a fixed time step of 1/60 s.
    public void Advance() => Check(Function<Step>(48)(world));

    // Unity is left-handed: z changes its sign.
    public void ExplodeAt(Vector3 place, double metres)
    {
        var edit = new Explosion { Size = (uint)Marshal.SizeOf<Explosion>(), X = place.x, Y = place.y, Z = -place.z };
        edit.Metres = metres;
        Check(Function<Explode>(72)(world, ref edit));
    }

    public void Dispose() => Check(Function<DestroyWorld>(32)(world));
}
